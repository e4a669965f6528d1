#include "sandbox/descriptor.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

namespace mc::sandbox {
namespace {

/// Descriptors below this are reserved for children: none of our own may be among them.
constexpr int lowest_own = 16;

}  // namespace

void fail(std::string_view action) {
  throw std::system_error(errno, std::generic_category(), std::string(action));
}

Descriptor::Descriptor(int raw, std::string_view action) {
  if (raw < 0) fail(action);
  value_ = fcntl(raw, F_DUPFD_CLOEXEC, lowest_own);
  const int error = errno;
  close(raw);
  if (value_ < 0) {
    errno = error;
    fail(action);
  }
}

Descriptor::Descriptor(Descriptor&& other) noexcept : value_(std::exchange(other.value_, -1)) {}

Descriptor& Descriptor::operator=(Descriptor&& other) noexcept {
  std::swap(value_, other.value_);
  return *this;
}

void Descriptor::reset() {
  if (value_ >= 0) close(std::exchange(value_, -1));
}

Pipe make_pipe() {
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) fail("pipe");  // no child of another thread inherits them
  Descriptor read;
  try {
    read = Descriptor(ends[0], "pipe");
  } catch (...) {
    close(ends[1]);
    throw;
  }
  return {std::move(read), Descriptor(ends[1], "pipe")};
}

bool read_available(const Descriptor& from, std::string& to, std::size_t most) {
  char buffer[1 << 16];
  while (to.size() <= most) {
    const ssize_t got = read(from.get(), buffer, sizeof buffer);
    if (got > 0) {
      to.append(buffer, static_cast<std::size_t>(got));
    } else if (got == 0) {
      return false;
    } else if (errno == EAGAIN || errno == EWOULDBLOCK) {
      return true;  // nothing more at the moment
    } else if (errno != EINTR) {
      return false;
    }
  }
  return true;
}

void open_standard_streams() {
  int raw = open("/dev/null", O_RDWR);
  while (raw >= 0 && raw <= 2) raw = open("/dev/null", O_RDWR);
  if (raw > 2) close(raw);
}

void make_nonblocking(const Descriptor& descriptor) {
  const int flags = fcntl(descriptor.get(), F_GETFL);
  if (flags < 0 || fcntl(descriptor.get(), F_SETFL, flags | O_NONBLOCK) != 0) fail("fcntl");
}

}  // namespace mc::sandbox
