#include "apps/mesh/matrix_market.hpp"

#include <gtest/gtest.h>

#include "apps/input/problem.hpp"

namespace liesl::test::matrix_market_test {
namespace {

using Eigen::MatrixXd;

TEST(MatrixMarket, WhatIsWrittenIsReadToTheLastBit) {
  Eigen::SparseMatrix<double> A(3, 3);
  A.insert(0, 0) = 1.0 / 3;
  A.insert(2, 0) = -1e-300;
  A.insert(1, 1) = 2.5e17;
  const Eigen::SparseMatrix<double> read = read_sparse("a.mtx", symmetric_text(A, "a matrix"));
  MatrixXd both = MatrixXd(A);
  both(0, 2) = both(2, 0);
  EXPECT_EQ(MatrixXd(read), both);
  const MatrixXd nodes = MatrixXd::Random(4, 3) / 7;
  EXPECT_EQ(read_dense("n.mtx", dense_text(nodes, "nodes")), nodes);
}

TEST(MatrixMarket, ReadsWhatOthersWrite) {
  const auto A = read_sparse("a.mtx",
                             "%%MatrixMarket MATRIX Coordinate Real General\r\n"
                             "% by hand\n\n2 3 3\n1 1 +1.5\n2 3 -2E-3\n2 3 1\n");
  EXPECT_EQ(A.rows(), 2);
  EXPECT_EQ(A.cols(), 3);
  EXPECT_EQ(A.coeff(0, 0), 1.5);
  EXPECT_EQ(A.coeff(1, 2), 1 - 2e-3);
}

TEST(MatrixMarket, EveryMistakeSaysWhereAndWhatWasExpected) {
  struct Case {
    std::string text, words;
    int line;
  };
  const std::string head = "%%MatrixMarket matrix coordinate real symmetric\n";
  for (const Case& c : {
           Case{"", "ends early", 0},
           Case{"1 2 3\n", "not a MatrixMarket file", 1},
           Case{"%%MatrixMarket matrix array real general\n", "another format", 1},
           Case{"%%MatrixMarket matrix coordinate complex symmetric\n", "another format", 1},
           Case{head + "2 2\n", "a line of 2 words", 2},
           Case{head + "2 3 1\n1 1 1\n", "symmetric matrix of 2 x 3", 2},
           Case{head + "2 2 2\n1 1 1\n", "ends early", 3},
           Case{head + "2 2 1\n3 1 1\n", "an entry at (3, 1)", 3},
           Case{head + "2 2 1\n0 1 1\n", "0 cannot be a size", 3},
           Case{head + "2 2 1\n1 2 1\n", "lower triangle", 3},
           Case{head + "2 2 1\n1 1 nan\n", "'nan' is not finite", 3},
           Case{head + "2 2 1\n1 1 one\n", "'one' is not a number", 3},
       }) {
    try {
      read_sparse("a.mtx", c.text);
      FAIL() << c.words;
    } catch (const InputError& error) {
      EXPECT_NE(error.problems[0].text().find(c.words), std::string::npos)
          << error.problems[0].text();
      EXPECT_EQ(error.problems[0].line, c.line) << c.words;
      EXPECT_EQ(error.problems[0].file, "a.mtx");
    }
  }
  EXPECT_THROW(read_dense("n.mtx", "%%MatrixMarket matrix array real general\n99999 99999\n1\n"),
               InputError);
}

}  // namespace
}  // namespace liesl::test::matrix_market_test
