/// @file
/// liesl: simulate flexible mechanisms on SE(3), size their parts under the loads of their motion.

#include "apps/cli/entry.hpp"

int main(int argc, char** argv) { return liesl::run_program(argc, argv); }
