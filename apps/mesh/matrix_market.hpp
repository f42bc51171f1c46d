#pragma once
/// @file
/// Matrices as MatrixMarket files: real, sparse (coordinate) or dense (array).
/// https://math.nist.gov/MatrixMarket/formats.html

#include <Eigen/SparseCore>
#include <string>
#include <string_view>

namespace liesl {

/// Both triangles of a matrix in `coordinate` format, `symmetric` (its lower triangle) or
/// `general`; entries of one place are summed. `file` names the text in messages.
/// @throws InputError with the line: another format, entries outside of the matrix, an upper
/// triangle of a symmetric matrix, numbers that are none or not finite, a file that ends early
Eigen::SparseMatrix<double> read_sparse(const std::string& file, std::string_view text);
/// A matrix in `array` format, `general`. @throws InputError, as above
Eigen::MatrixXd read_dense(const std::string& file, std::string_view text);

/// `coordinate real symmetric` of a lower triangle, every digit.
std::string symmetric_text(const Eigen::SparseMatrix<double>& lower, const std::string& comment);
/// `array real general`.
std::string dense_text(const Eigen::MatrixXd& matrix, const std::string& comment);

}  // namespace liesl
