#pragma once
// Replaces labs/runner/wire.hpp in programs that lie to the judge: they send the solution's answer
// with some numbers, or the lengths of lists, replaced. See mutation.hpp.

#define Writer HonestWriter
#include "../../../../labs/runner/wire.hpp"
#undef Writer

#include "mutation.hpp"

namespace mc::wire {

class Writer {
 public:
  std::string bytes;

  template <Arithmetic T>
  void put(const T& value) {
    const T sent = fuzz::mutated(value);
    append(&sent, sizeof sent);
  }
  void put(const std::string& text) {
    put_size(text.size());
    append(text.data(), text.size());
  }
  template <class T>
  void put(const std::vector<T>& values) {
    const std::size_t size = fuzz::mutated_size(values.size());
    put_size(size);
    for (std::size_t i = 0; i < size; ++i) put(values.empty() ? T{} : values[i % values.size()]);
  }
  template <Listed T>
  void put(const T& value) {
    std::apply([this](const auto&... field) { (put(field), ...); }, fields(const_cast<T&>(value)));
  }

 private:
  void put_size(std::uint64_t size) { append(&size, sizeof size); }
  void append(const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
  }
};

}  // namespace mc::wire
