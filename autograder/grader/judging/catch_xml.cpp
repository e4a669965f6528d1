#include "grader/judging/catch_xml.hpp"

#include <utility>

#include <fmt/format.h>
#include <pugixml.hpp>

namespace mc::grader {
namespace {

std::string trimmed(std::string_view text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return {};
  return std::string(text.substr(first, text.find_last_not_of(" \t\r\n") - first + 1));
}

/// Of a FAIL: its text. Of a REQUIRE or CHECK: what was asked and what it came to.
std::string message_of(const pugi::xml_node& failure) {
  if (std::string_view(failure.name()) != "Expression") {
    const std::string text = trimmed(failure.text().get());
    return text.empty() ? failure.name() : text;
  }
  const std::string asked = fmt::format("{}({})", failure.attribute("type").value(),
                                        trimmed(failure.child("Original").text().get()));
  if (const auto thrown = failure.child("Exception")) {
    return fmt::format("{} threw: {}", asked, trimmed(thrown.text().get()));
  }
  return fmt::format("{} was {}", asked, trimmed(failure.child("Expanded").text().get()));
}

}  // namespace

std::vector<XmlRecord> read_catch_xml(std::string_view xml) {
  pugi::xml_document document;
  std::vector<XmlRecord> records;
  if (!document.load_buffer(xml.data(), xml.size())) return records;  // cut short: no record at all
  for (const auto& found : document.select_nodes("//TestCase")) {
    const pugi::xml_node node = found.node();
    const pugi::xml_node overall = node.child("OverallResult");
    XmlRecord record{node.attribute("name").value(), node.attribute("tags").value(), false, {}};
    record.success = overall.attribute("success").as_bool();
    const auto failures = node.select_nodes(
        ".//Failure | .//Exception | .//FatalErrorCondition | .//Expression[@success='false']");
    if (!failures.empty()) {
      const pugi::xml_node failure = failures.first().node();  // in the order of the report
      const std::string_view kind = failure.name();
      record.message = message_of(failure);
      record.crashed =
          kind == "Exception" || kind == "FatalErrorCondition" || failure.child("Exception");
    }
    // Catch2 calls [!mayfail] and [!shouldfail] a success; here a failure is a failure.
    if (!record.message.empty()) record.success = false;
    if (!record.success && record.message.empty()) record.message = "this check checked nothing";
    records.push_back(std::move(record));
  }
  return records;
}

}  // namespace mc::grader
