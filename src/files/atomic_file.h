// Files that appear complete or not at all.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>

#include "sturnus/result.h"

namespace sturnus {

/// Writes the bytes beside `path` under another name, brings them to the disk and renames. Where anything
/// fails, whatever `path` named before is untouched. A device or a pipe (/dev/stdout) is written directly.
Status write_file(const std::string& path, std::span<const unsigned char> bytes);
Status write_file(const std::string& path, std::string_view text);

/// Creates a folder and those above it. No error when it is there.
Status make_folders(const std::string& path);

/// The folder part of a path with its last slash; empty when there is none.
std::string folder_of(const std::string& path);

/// An unused name in the same folder, hidden from listings, for a file that is not finished. Two processes
/// never get the same one.
std::string unfinished_name(const std::string& path);

/// "out/flock.png: cannot be written: No space left on device"
Problem cannot_write(const std::string& path, int error_number);

/// Whether a name stands for a device, a pipe or a descriptor such as /dev/stdout, which are written
/// directly.
bool is_stream(const std::string& path);

/// Why `path` cannot be written as a regular file, found before any work is done: it is a folder, or its
/// folder is missing or closed to us.
Status check_writable(const std::string& path);

/// Brings a finished file to the disk and gives it its name. Removes it when that fails.
Status publish(const std::string& unfinished, const std::string& path);

}  // namespace sturnus
