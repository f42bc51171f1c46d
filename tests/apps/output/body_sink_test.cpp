/// Results whose bodies went to results.h5 by blocks of records: the files of results that hold
/// all.

#include <gtest/gtest.h>

#include <algorithm>

#include "apps/hdf5_set.hpp"
#include "apps/output/data_tree.hpp"
#include "apps/output/file.hpp"
#include "apps/output/hdf5_input.hpp"
#include "apps/output/write_results.hpp"
#include "tests/apps/output_sample.hpp"

namespace liesl::test::body_sink_test {
namespace {

using namespace output;

constexpr std::size_t kRecords = 40;

Results results() {
  const std::size_t n = kRecords;
  Results r;
  r.name = "blocks";
  r.space = "spatial";
  r.times = counting(n, 0);
  r.bodies = sample_bodies(n);
  r.bodies[0].reference_positions = counting(9, 3);
  r.energies.total = counting(n);
  r.responses.push_back({"tip", "m", 3, counting(n * 3)});
  return r;
}

/// The bodies at some of their records.
std::vector<BodyResult> at(const std::vector<BodyResult>& bodies, const std::vector<int>& records) {
  std::vector<BodyResult> out = bodies;
  for (std::size_t b = 0; b < out.size(); ++b)
    for (const auto block : kBodySeries) {
      const std::vector<double>& from = bodies[b].*block;
      std::vector<double>& to = out[b].*block;
      const auto size = static_cast<long>(from.size() / kRecords);
      to.clear();
      for (const int record : records)
        to.insert(to.end(), from.begin() + size * record, from.begin() + size * (record + 1));
    }
  return out;
}

/// Hands all records to the file, `most` at a time.
void put(const std::vector<BodyResult>& bodies, std::size_t most, Hdf5Writer& file) {
  for (std::size_t first = 0; first < kRecords; first += most) {
    std::vector<int> records;
    for (std::size_t i = first; i < std::min(first + most, kRecords); ++i)
      records.push_back(static_cast<int>(i));
    file.put(at(bodies, records), first, records.size(), kRecords);
  }
}

TEST(BodySink, BlocksMakeTheSameFiles) {
  const Results all = results();
  const TemporaryFolder whole;
  write_results(whole.path(), all);
  const DataTree tree = data_tree(all);
  for (const std::size_t most : {1, 7, 40}) {
    const TemporaryFolder blocks;
    Hdf5Writer file(blocks / "results.h5");
    put(all.bodies, most, file);
    Results few = all;
    few.kept = spread_records(kRecords, kFrames);
    few.bodies = at(all.bodies, few.kept);
    write_results(blocks.path(), few, &file);
    for (const output::DataSet& set : tree.sets) {
      if (std::holds_alternative<std::vector<std::string>>(set.values)) continue;
      const test::DataSet expected = read_set(whole / "results.h5", set.name),
                          found = read_set(blocks / "results.h5", set.name);
      EXPECT_EQ(found.shape, expected.shape) << set.name;
      EXPECT_EQ(found.values, expected.values) << set.name << " by " << most;
      EXPECT_FALSE(found.values.empty()) << set.name;
    }
    for (const char* name : {"results.xdmf", "frames.csv", "energies.csv", "responses.csv"})
      EXPECT_EQ(read_file(blocks / name), read_file(whole / name)) << name;
  }
}

/// Near to each other or far apart: those of the whole.
TEST(Hdf5Records, AreReadAlone) {
  const TemporaryFolder place;
  Results all = results();
  write_hdf5(place / "r.h5", all);
  const Hdf5Input file(place / "r.h5");
  for (const std::vector<int>& records : std::vector<std::vector<int>>{
           {0}, {39}, {0, 1, 2, 38, 39}, {0, 4, 8, 12, 17}, {3, 20, 21, 39}, {0, 5, 10}}) {
    const Hdf5Numbers some = file.numbers("/bodies/rod/position", records);
    EXPECT_EQ(some.shape, (std::vector<std::size_t>{records.size(), 3, 3}));
    all.bodies = at(results().bodies, records);
    EXPECT_EQ(some.values, all.bodies[0].positions);
  }
}

TEST(BodySink, RecordsThatAreNotKeptAreRefused) {
  Results few = results();
  EXPECT_EQ(few.row(7), 7u);
  few.kept = {0, 5, 39};
  EXPECT_EQ(few.row(5), 1u);
  EXPECT_EQ(few.row(39), 2u);
  EXPECT_THROW(few.row(7), std::out_of_range);
  EXPECT_THROW(check_shapes(few), std::invalid_argument) << "all records are still there";
  few.bodies = at(few.bodies, few.kept);
  EXPECT_NO_THROW(check_shapes(few));
}

TEST(BodySink, SeriesDoNotChangeBetweenBlocks) {
  const TemporaryFolder place;
  Hdf5Writer file(place / "results.h5");
  auto bodies = at(results().bodies, {0, 1});
  file.put(bodies, 0, 2, kRecords);
  bodies[0].strains.clear();
  EXPECT_THROW(file.put(bodies, 2, 2, kRecords), std::invalid_argument);
}

/// Before numbers, after some, in the end: the file is made before they come.
TEST(BodySink, AFileThatIsNotFinishedIsTakenAway) {
  const TemporaryFolder place;
  const auto path = place / "results.h5";
  { const Hdf5Writer file(path); }
  EXPECT_FALSE(std::filesystem::exists(path));
  {
    Hdf5Writer file(path);
    file.put(at(results().bodies, {0, 1}), 0, 2, kRecords);
    EXPECT_TRUE(std::filesystem::exists(path));
    file.discard();
    EXPECT_FALSE(std::filesystem::exists(path));
  }
  write_hdf5(path, results());
  EXPECT_TRUE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace liesl::test::body_sink_test
