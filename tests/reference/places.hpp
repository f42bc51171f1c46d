#pragma once
/// @file
/// Where the data and the program under test lie (defined in a source that the build generates).

namespace liesl::test {

extern const char* const kDataDir;
extern const char* const kProgram;

}  // namespace liesl::test
