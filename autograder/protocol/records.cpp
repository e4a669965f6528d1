#include "protocol/records.hpp"

#include <array>
#include <cstdio>
#include <cstdlib>

namespace mc::protocol {
namespace {

/// In the order of RecordKind.
constexpr std::array<std::string_view, 8> names{"printed", "todo",   "p_value", "call",
                                                "cost",    "growth", "machine", "ended"};

std::string escaped(std::string_view text) {
  std::string line;
  for (const char c : text) {
    if (c == '\n') {
      line += "\\n";
    } else {
      if (c == '\\') line += '\\';
      line += c;
    }
  }
  return line;
}

std::string unescaped(std::string_view line) {
  std::string text;
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (line[i] == '\\' && i + 1 < line.size()) {
      text += line[++i] == 'n' ? '\n' : line[i];
    } else {
      text += line[i];
    }
  }
  return text;
}

}  // namespace

std::string line_of(const Record& record) {
  return std::string(names[static_cast<std::size_t>(record.kind)]) + ' ' + escaped(record.text);
}

std::vector<Record> records_in(std::string_view lines) {
  std::vector<Record> records;
  while (!lines.empty()) {
    const auto end = lines.find('\n');
    const std::string_view line = lines.substr(0, end);
    lines.remove_prefix(end == std::string_view::npos ? lines.size() : end + 1);
    const auto blank = line.find(' ');
    if (blank == std::string_view::npos) continue;
    for (std::size_t kind = 0; kind < names.size(); ++kind) {
      if (line.substr(0, blank) != names[kind]) continue;
      records.push_back({static_cast<RecordKind>(kind), unescaped(line.substr(blank + 1))});
    }
  }
  return records;
}

std::string text_of(const CheckEnd& end) {
  return end.name + '\n' + end.tags + '\n' + (end.passed ? '1' : '0') + (end.crashed ? '1' : '0') +
         '\n' + end.message;
}

std::vector<CheckEnd> check_ends_in(const std::vector<Record>& records) {
  std::vector<CheckEnd> ends;
  for (const Record& record : records) {
    if (record.kind != RecordKind::ended) continue;
    const std::string& text = record.text;
    const auto name = text.find('\n'), tags = text.find('\n', name + 1);
    if (name == std::string::npos || tags == std::string::npos || text.size() < tags + 4) continue;
    ends.push_back({text.substr(0, name), text.substr(name + 1, tags - name - 1),
                    text[tags + 1] == '1', text[tags + 2] == '1', text.substr(tags + 4)});
  }
  return ends;
}

std::string text_of(const PValue& value) {
  char numbers[64];
  std::snprintf(numbers, sizeof numbers, "%.6g %.6g ", value.p, value.alpha);
  return numbers + value.null;
}

PValue p_value_in(const std::string& text) {
  PValue value;
  char* end = nullptr;
  value.p = std::strtod(text.c_str(), &end);
  value.alpha = std::strtod(end, &end);
  while (*end == ' ') ++end;
  value.null = end;
  return value;
}

}  // namespace mc::protocol
