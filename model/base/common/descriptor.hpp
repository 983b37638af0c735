#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <utility>

namespace mixcmp::inline common {

/// An open file descriptor, closed by the destructor; -1: none.
class Descriptor {
public:
  explicit Descriptor(int value = -1) : value_(value) {}
  Descriptor(Descriptor&& other) noexcept : value_(other.release()) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  Descriptor& operator=(Descriptor&&) = delete;
  ~Descriptor() { reset(); }
  int get() const { return value_; }
  int release() { return std::exchange(value_, -1); }
  void reset(int value = -1) {
    if (value_ >= 0) close(value_);
    value_ = value;
  }

private:
  int value_;
};

/// A pipe whose ends other programs do not inherit.
struct Pipe {
  Descriptor read_end, write_end;

  bool open() {
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return false;
    read_end.reset(ends[0]);
    write_end.reset(ends[1]);
    return true;
  }
};

}  // namespace mixcmp::inline common
