#pragma once
// The wire between a judge and a submission's program: the request for a measurement (on descriptor
// 0) and the response (on descriptor 3). Both ends run on one machine, so numbers are sent as their
// own bytes.
//
//   request  = name, arguments                                   (a name is a string)
//            | "", a list of requests: all in this process, in order; the result is a list of
//              strings, each a status in one byte and the bytes of its result
//   response = magic, status, length, exactly `length` bytes, end
//              the bytes are the result, or the text of the exception

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

/// Lists the fields of a struct, for the wire and for printing. Use it in the struct's namespace,
/// with every field in order: MC_FIELDS(Moments, count, mean, m2)
#define MC_FIELDS(Type, ...)                                   \
  inline auto fields(Type& object_) {                          \
    auto& [__VA_ARGS__] = object_;                             \
    return std::tie(__VA_ARGS__);                              \
  }                                                            \
  inline constexpr std::string_view field_names(const Type&) { \
    return #__VA_ARGS__;                                       \
  }

namespace mc::wire {

enum class Status : std::uint32_t { value, todo, invalid_argument, out_of_range, other_exception };

constexpr std::uint64_t magic = 0x6d632d6c6162730au;  // "mc-labs\n"
constexpr std::size_t longest_result = std::size_t{16} << 20;

struct Header {
  std::uint64_t magic;
  Status status;
  std::uint32_t reserved;  // zero
  std::uint64_t length;
};

/// Bytes that do not have the expected types.
struct malformed : std::runtime_error {
  using std::runtime_error::runtime_error;
};

template <class T>
concept Arithmetic = std::is_arithmetic_v<T> && !std::is_same_v<T, bool>;

template <class T>
concept Listed = requires(T& value) {
  fields(value);
};

class Writer {
 public:
  std::string bytes;

  template <Arithmetic T>
  void put(const T& value) {
    append(&value, sizeof value);
  }
  void put(const std::string& text) {
    put(std::uint64_t{text.size()});
    append(text.data(), text.size());
  }
  template <class T>
  void put(const std::vector<T>& values) {
    put(std::uint64_t{values.size()});
    if constexpr (Arithmetic<T>) {
      append(values.data(), values.size() * sizeof(T));
    } else {
      for (const T& value : values) put(value);
    }
  }
  template <Listed T>
  void put(const T& value) {
    std::apply([this](const auto&... field) { (this->put(field), ...); },
               fields(const_cast<T&>(value)));
  }

 private:
  void append(const void* data, std::size_t size) {
    bytes.append(static_cast<const char*>(data), size);
  }
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : left_(bytes) {}

  template <Arithmetic T>
  void get(T& value) {
    take(&value, sizeof value);
  }
  void get(std::string& text) {
    text.resize(get_size());
    take(text.data(), text.size());
  }
  template <class T>
  void get(std::vector<T>& values) {
    const std::uint64_t size = get_size();
    values.clear();
    if constexpr (Arithmetic<T>) {
      if (size > left_.size() / sizeof(T)) throw malformed("too short");
      values.resize(size);
      take(values.data(), size * sizeof(T));
    } else {  // one by one: memory for the values received, not for the claimed number
      for (std::uint64_t i = 0; i < size; ++i) get(values.emplace_back());
    }
  }
  template <Listed T>
  void get(T& value) {
    std::apply([this](auto&... field) { (this->get(field), ...); }, fields(value));
  }
  template <class T>
  T get() {
    T value{};
    get(value);
    return value;
  }
  void end() const {
    if (!left_.empty()) throw malformed("bytes left over");
  }

 private:
  std::uint64_t get_size() {
    std::uint64_t size = 0;
    get(size);
    if (size > left_.size()) throw malformed("a list longer than the message");
    return size;
  }
  void take(void* data, std::size_t size) {
    if (size > left_.size()) throw malformed("too short");
    if (size > 0) std::memcpy(data, left_.data(), size);
    left_.remove_prefix(size);
  }
  std::string_view left_;
};

}  // namespace mc::wire
