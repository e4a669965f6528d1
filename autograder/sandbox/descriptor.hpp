#pragma once
// A file descriptor that closes itself, and pipes made of them.

#include <string>
#include <string_view>

namespace mc::sandbox {

/// Owns a file descriptor: moved, never copied, closed on destruction and on exec.
class Descriptor {
 public:
  Descriptor() = default;
  /// Takes ownership of `raw` and moves it to a number that no child inherits (children use a few
  /// low ones). Throws std::system_error, with `action` in its text, if `raw` is negative, so the
  /// result of open() can be passed directly.
  Descriptor(int raw, std::string_view action);
  Descriptor(Descriptor&& other) noexcept;
  Descriptor& operator=(Descriptor&& other) noexcept;
  ~Descriptor() { reset(); }

  void reset();
  int get() const { return value_; }
  explicit operator bool() const { return value_ >= 0; }

 private:
  int value_ = -1;
};

struct Pipe {
  Descriptor read, write;
};

/// An anonymous pipe, both ends closed on exec. Throws std::system_error.
Pipe make_pipe();

/// Appends what can be read now to `to`, until it is longer than `most`. False at the end of the
/// stream, and if reading fails.
bool read_available(const Descriptor& from, std::string& to, std::size_t most);

/// Opens /dev/null as 0, 1 and 2 where the caller closed them: a file opened later would be taken
/// for standard output.
void open_standard_streams();

void make_nonblocking(const Descriptor& descriptor);

/// Throws a std::system_error for errno.
[[noreturn]] void fail(std::string_view action);

}  // namespace mc::sandbox
