#pragma once
/// @file
/// The results of a simulation as named data sets: the layout of results.h5, and the names by which
/// Python finds the same numbers.

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "apps/output/results.hpp"

namespace liesl::output {

/// Numbers are those of the results, which outlive the data set; `made` holds those that are made
/// of them.
struct DataSet {
  std::string name;  ///< "/bodies/rod/position"
  std::variant<std::span<const double>, std::vector<int>, std::vector<std::string>> values;
  std::vector<std::size_t> shape;
  std::string unit;  ///< empty: has none
  std::shared_ptr<const std::vector<double>> made = {};
};

/// A group, or the root "/", with its text attributes.
struct DataGroup {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;
};

struct DataTree {
  std::vector<DataGroup> groups;  ///< each after the one it is in
  std::vector<DataSet> sets;
};

/// Everything that is recorded; layout in docs/outputs.md:
///   /time [n]                      attributes of the root: program, scene, space, abscissa
///   /bodies/<name>/{position [n,N,3], rotation [n,N,9], velocity [n,N,6], elements [E,2],
///                   strain [n,E,6], section_force [n,E,12],
///                   node_force [n,N,6]}                             attribute kind
///   /joints/<name>/{coordinate [n,K], force [n,6]}                  attribute type
///   /energies/{kinetic, elastic, potential, dissipated, total} [n]
///   /constraint_residual [n]
///   /responses/<name> [n,C]
/// Without the groups and series of bodies that a BodySink took (Results::kept).
/// @throws std::invalid_argument (shapes)
DataTree data_tree(const Results& results);

/// The groups of bodies, with their series of n records alone.
DataTree series_tree(const std::vector<BodyResult>& bodies, std::size_t n);

/// The name as a link of HDF5: a slash, which would be a group, becomes an underscore.
std::string hdf5_name(std::string name);

}  // namespace liesl::output
