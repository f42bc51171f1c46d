#pragma once
/// @file
/// From the arguments of the program to its exit code.

namespace liesl {

/// Runs the command that the arguments name. 0 done, 1 ran but did not converge or is infeasible, 2
/// refused (arguments or input), 3 files or memory; what is wrong is printed.
int run_program(int argc, char** argv);

}  // namespace liesl
