// One child process that reads what we write to it, and whose complaints are kept.
#pragma once

#include <sys/types.h>

#include <span>
#include <string>
#include <vector>

#include "sturnus/result.h"

namespace sturnus {

class Process {
 public:
  Process() = default;
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  /// Kills the child when it still runs, and waits for it.
  ~Process();

  /// Starts words[0], looked up on the PATH, with the other words as its arguments; no shell reads them.
  /// Returns 0 or an errno. Ctrl-C does not reach it: whether to stop or to finish is this program's choice.
  int start(const std::vector<std::string>& words);

  /// 0, or the errno of the write that failed: EPIPE when the child has gone.
  int write(std::span<const unsigned char> bytes);

  /// Ends the child's input and waits for its end. The exit status, or 128 plus the signal that killed it.
  int wait();

  void kill();

  /// The last line that the child wrote to its standard error and that is not empty.
  std::string last_complaint() const;

 private:
  pid_t child_ = -1;
  int input_ = -1;       // our end of the pipe to it
  int complaints_ = -1;  // a nameless file, which unlike a pipe cannot fill up and stop the child
};

}  // namespace sturnus
