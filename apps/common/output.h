// What the program says: results on standard output, everything else in sentences on standard error.
#pragma once

#include <sturnus/result.h>

#include <cstdint>
#include <string>

namespace program {

/// How the program ends.
enum Exit : int {
  done = 0,
  failed = 1,         ///< while running: an output that can't be written, no ffmpeg, a full disk
  bad_input = 2,      ///< wrong usage or a wrong file
  different = 3,      ///< what was compared differs
  interrupted = 130,  ///< by Ctrl-C, with what was done written
};

/// Writes to standard output. What goes wrong is kept for `finish`.
void print(const std::string& text);
/// Shows at once what was printed so far, where it would else wait for more.
void show_output();
/// Writes a sentence to standard error as a line of its own.
void tell(const std::string& sentence);
/// Writes all problems to standard error, one a line.
void tell(const sturnus::Problems& problems);

/// Says why the input is bad; returns `bad_input`.
int refuse(const sturnus::Problems& problems);
int refuse(const std::string& sentence);
/// Says what went wrong in the work; returns `failed`.
int fail(const sturnus::Problems& problems);

/// Brings standard output to its end. Where that fails the program has failed, and says so, except to a
/// reader who has gone away (`sturnus keys | head`).
int finish(int code);

/// "1 step", "2 steps".
std::string counted(std::uint64_t count, const char* noun);

/// Text as printf makes it.
[[gnu::format(printf, 1, 2)]] std::string format(const char* pattern, ...);

}  // namespace program
