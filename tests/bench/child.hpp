#pragma once

// Processes of a bench: forked with a piece of work or started as a program; they end with this object, and with the
// bench however it ends.
//
//   Child watcher = Child::running([&](Pipe& parent) { parent.say(median_latency()); });
//   watcher.pipe().hear();                       // waits for the number
//
// Fork before this process has threads: before it has a ZeroMQ context.

#include <functional>
#include <string>
#include <sys/types.h>
#include <utility>
#include <vector>

namespace pizarra::bench {

// Numbers and lines between a child and its parent. A missing answer ends the bench after a minute.
class Pipe {
 public:
  explicit Pipe(int file) : file_(file) {}
  Pipe(Pipe&& other) noexcept;
  Pipe& operator=(Pipe&&) = delete;
  ~Pipe();
  int file() const { return file_; }
  void say(double value);
  double hear();
  std::string hear_line();

 private:
  void read_some(void* into, std::size_t size);
  int file_;
};

class Child {
 public:
  static Child running(const std::function<void(Pipe& parent)>& work);
  // Its standard output is the pipe.
  static Child program(const std::vector<std::string>& command);
  Child(Child&& other) noexcept;
  Child& operator=(Child&&) = delete;
  ~Child();

  Pipe& pipe() { return pipe_; }
  void signal(int number) const;
  // Whether it has ended by itself.
  bool ended() const;
  // A line of its /proc/PID/status, as VmRSS or VmHWM.
  double memory_mb(const std::string& name) const;
  // Of the processor, in all of its threads, ended ones too.
  double cpu_s() const;
  // How long its threads that still are have waited for a core, though they had something to do.
  double waited_for_core_ms() const;

 private:
  Child(pid_t process, int file) : process_(process), pipe_(file) {}
  pid_t process_;
  Pipe pipe_;
};

// Removed with all that is in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  TemporaryFolder(TemporaryFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder();
  const std::string& path() const { return path_; }

 private:
  std::string path_;
};

// A program that was built beside this one.
std::string program_beside(const std::string& name);

}  // namespace pizarra::bench
