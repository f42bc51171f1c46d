#pragma once
/// @file
/// Cases from a CSV table: a row a case, a column a key; a column `case` may name the cases.
///
///     case,joints.motor.drive.rate,constraints.bending.limit
///     slow,100,1e-3
///     fast,150,1e-3

#include <string>

#include "apps/batch/case_list.hpp"

namespace liesl {

/// A field of a CSV file with its place. RFC 4180: commas, quotes, doubled quotes, any line end.
using CsvRow = std::vector<CaseValue>;
/// Rows of a text; lines without any character are skipped. A quote that is not closed is an error.
std::vector<CsvRow> read_csv(const std::string& text, const std::string& file, Problems& problems);

/// Cases of a table. Says columns that are empty, twice there or have the name of a column of the
/// results; rows that are too long or too short; empty fields; names that are no names of folders
/// or twice there; a table without rows. Without a column `case`, cases are numbered.
CaseList read_cases(const std::string& text, const std::string& file, Problems& problems);

/// Names of columns that every table of results has: "case", "status", ...
bool reserved(const std::string& column);

}  // namespace liesl
