// Of texts, those that RFC 8259 calls JSON are read, with their values; others are refused at the
// byte that is wrong.
#include <doctest/doctest.h>

#include <string>

#include "io/json_value.h"

namespace tetsculpt {
namespace {

double number(const std::string& text) {
  const JsonValue value = parse_json(text);
  REQUIRE(value.as<double>() != nullptr);
  return *value.as<double>();
}

std::string text_in(const std::string& text) {
  const JsonValue value = parse_json(text);
  REQUIRE(value.as<std::string>() != nullptr);
  return *value.as<std::string>();
}

std::string refusal(const std::string& text) {
  try {
    parse_json(text);
  } catch (const JsonError& error) {
    return std::to_string(error.offset()) + ": " + error.what();
  }
  return "read";
}

TEST_CASE("values") {
  CHECK(parse_json(" null\t").as<std::nullptr_t>() != nullptr);
  CHECK(*parse_json("true").as<bool>());
  CHECK_FALSE(*parse_json("\r\nfalse").as<bool>());
  CHECK(parse_json("[]").as<JsonValue::List>()->empty());
  CHECK(parse_json("{ }").as<JsonValue::Object>()->empty());
  const JsonValue object = parse_json(R"({"b":[1,{"c":2}],"a":"x","":3})");
  CHECK(object.as<JsonValue::Object>()->size() == 3);
  CHECK(*object.member("a")->as<std::string>() == "x");
  CHECK(*object.member("")->as<double>() == 3);
  CHECK(object.member("c") == nullptr);
  const JsonValue::List& list = *object.member("b")->as<JsonValue::List>();
  CHECK(*list[1].member("c")->as<double>() == 2);
  CHECK(list[1].offset == 8);
  CHECK(list[0].member("c") == nullptr);
}

TEST_CASE("numbers") {
  CHECK(number("0") == 0);
  CHECK(number("-12.5e-1") == -1.25);
  CHECK(number("1E+2") == 100);
  CHECK(number("0.1") == 0.1);
  CHECK(refusal("01") == "1: text behind the JSON value");
  CHECK(refusal("+1") == "0: expected a value");
  CHECK(refusal(".5") == "0: expected a value");
  CHECK(refusal("1.") == "2: expected a digit");
  CHECK(refusal("1.5e") == "4: expected a digit");
  CHECK(refusal("-") == "1: the text ends early");
  CHECK(refusal("[1e999]") == "1: number out of range");
  CHECK(refusal("nan") == "0: expected a JSON value");
  CHECK(refusal("Infinity") == "0: expected a value");
}

TEST_CASE("texts") {
  CHECK(text_in(R"("a\"\\\/\b\f\n\r\t")") == "a\"\\/\b\f\n\r\t");
  CHECK(text_in(R"("\u0041\u00e9\u20AC\ud83D\ude00")") == "A\xC3\xA9\xE2\x82\xAC\xF0\x9F\x98\x80");
  CHECK(text_in("\"\xC3\xA9\"") == "\xC3\xA9");
  CHECK(refusal("\"a") == "2: a text without its end");
  CHECK(refusal("\"a\n\"") == "2: a control character in a text");
  CHECK(refusal(R"("\x")") == "2: an unknown escape in a text");
  CHECK(refusal("\"\\") == "2: an unknown escape in a text");
  CHECK(refusal(R"("\u12")") == "2: an escape needs four hexadecimal digits");
  CHECK(refusal(R"("\ud800x")") == "7: half a surrogate pair");
  CHECK(refusal(R"("\udc00")") == "7: half a surrogate pair");
  CHECK(refusal(R"("\ud800\u0041")") == "13: half a surrogate pair");
}

TEST_CASE("what is no JSON") {
  CHECK(refusal("") == "0: the text ends early");
  CHECK(refusal("{} {}") == "3: text behind the JSON value");
  CHECK(refusal("[1,]") == "3: expected a value");
  CHECK(refusal("[1 2]") == "3: expected ] in a list");
  CHECK(refusal("{\"a\" 1}") == "5: expected : in an object");
  CHECK(refusal("{\"a\":1,}") == "7: expected the name of a member");
  CHECK(refusal("{a:1}") == "1: expected the name of a member");
  CHECK(refusal("[1] // x") == "4: text behind the JSON value");
  CHECK(refusal(R"({"a":1,"b":2,"a":3})") == "17: the member a again");
  CHECK(refusal("tru") == "0: expected a JSON value");
}

TEST_CASE("depth is bounded") {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + '1' + std::string(depth, ']');
  };
  CHECK(refusal(nested(200)) == "read");
  CHECK(refusal(nested(100'000)) == "201: values nested deeper than 200");
}

}  // namespace
}  // namespace tetsculpt
