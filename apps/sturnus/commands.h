// The commands of the program, each in a file of its own, and how they are made known to the command line.
#pragma once

#include "main_program.h"

namespace program {

void add_run(CLI::App& app, Request& request);
void add_sweep(CLI::App& app, Request& request);
void add_render(CLI::App& app, Request& request);
void add_list(CLI::App& app, Request& request);
void add_show(CLI::App& app, Request& request);
void add_keys(CLI::App& app, Request& request);
void add_new(CLI::App& app, Request& request);
void add_check(CLI::App& app, Request& request);
void add_bench(CLI::App& app, Request& request);
void add_explain(CLI::App& app, Request& request);
void add_compare(CLI::App& app, Request& request);
void add_shadertoy(CLI::App& app, Request& request);
void add_studio(CLI::App& app, Request& request);

}  // namespace program
