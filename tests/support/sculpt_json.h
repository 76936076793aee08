#pragma once

#include <cstddef>
#include <map>
#include <stdexcept>
#include <string>
#include <string_view>

#include "tests/support/io_json.h"

/// JSON as the command line writes it, by names.
namespace tetsculpt::testing {

using JsonMembers = std::map<std::string, std::string>;

/// Reads an object. Members of an inner object are named outer.inner, items of an array outer[0];
/// the value of a text keeps its quotes, that of an object is `object` and that of an array
/// `array`. A member that occurs twice, or a thing that is no JSON, is an exception.
class JsonReader {
 public:
  explicit JsonReader(std::string_view text) : value_(JsonParser(text).parse()) {}

  JsonMembers read() {
    if (value_.kind != Json::Kind::kObject) throw std::runtime_error("no object");
    add_members(value_, "");
    return members_;
  }

 private:
  void add_members(const Json& object, const std::string& prefix) {
    for (const auto& [name, value] : object.members) add(prefix + name, value);
  }

  void add(const std::string& name, const Json& value) {
    std::string text = value.text;
    if (value.kind == Json::Kind::kText) text = '"' + text + '"';
    if (value.kind == Json::Kind::kObject) {
      text = "object";
      add_members(value, name + '.');
    }
    if (value.kind == Json::Kind::kList) {
      text = "array";
      for (std::size_t i = 0; i < value.items.size(); ++i) {
        add(name + '[' + std::to_string(i) + ']', value.items[i]);
      }
    }
    if (!members_.emplace(name, text).second) throw std::runtime_error(name);
  }

  Json value_;
  JsonMembers members_;
};

}  // namespace tetsculpt::testing
