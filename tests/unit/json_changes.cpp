// SPDX-License-Identifier: MIT
// Changes to a JSON text: the named parts change, and nothing else does.
#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <json_changes.h>

using namespace lichen;
using nlohmann::json;

namespace {

std::string changed(const std::string& text, const JsonChange& change) {
  const Result<std::string> result = changedJson(text, change);
  INFO((result ? "" : result.error().message));
  REQUIRE(result.ok());
  CHECK_NOTHROW(json::parse(result.value()));
  return result.value();
}

std::string faultOf(const std::string& text, const JsonChange& change) {
  const Result<std::string> result = changedJson(text, change);
  REQUIRE(!result.ok());
  CHECK(result.error().kind == ErrorKind::badInput);
  return result.error().message;
}

} // namespace

TEST_CASE("a text without changes keeps every byte") {
  for (const std::string text :
       {R"({})", " { } \n", R"({"a":1.0,"b" : [ 1e5 ,"\u00e9\\\"]" ] , "a":{"":null}})",
        "{\n  \"x\": [\n  ]\n}\n"})
    CHECK(changed(text, {}) == text);
}

TEST_CASE("members and elements are added with the indentation of their neighbours") {
  JsonChange change;
  change.member("list").append(3);
  change.member("new").member("inside").set("x");
  CHECK(changed(R"({"list":[1,2.50]})", change) == R"({"list":[1,2.50,3],"new":{"inside":"x"}})");
  CHECK(changed("{\n  \"list\": [\n    1\n  ]\n}\n", change) ==
        "{\n  \"list\": [\n    1,\n    3\n  ],\n  \"new\": {\"inside\":\"x\"}\n}\n");
  CHECK(changed("{}", change) == R"({"list":[3],"new":{"inside":"x"}})");
  CHECK(changed(R"({"list" : [ ] , "new" : { } })", change) ==
        R"({"list" : [ 3] , "new" : { "inside" : "x"} })");
}

TEST_CASE("replacing and removing members leaves the bytes of their neighbours unchanged") {
  JsonChange change;
  change.member("b").element(1).member("c").set(true);
  change.member("first").remove();
  change.member("last").remove();
  change.member("absent").remove();
  CHECK(changed(R"({"first":[{}],  "b": [ 7.0, {"c":{"x":[1,2]} , "d" : 0}, "]" ] , "last":1e9 })",
                change) == R"({  "b": [ 7.0, {"c":true , "d" : 0}, "]" ] })");
  JsonChange only;
  only.member("a").remove();
  CHECK(changed(R"({"a":1})", only) == "{}");
}

TEST_CASE("keys are compared after unescaping") {
  JsonChange change;
  change.member("é\"").set(1);
  CHECK(changed(R"({"\u00e9\"":0,"e":"}"})", change) == R"({"\u00e9\"":1,"e":"}"})");
}

TEST_CASE("changing a missing or repeated value, or one of another type, is an error that states "
          "its pointer") {
  JsonChange append;
  append.member("a").append(1);
  CHECK_THAT(faultOf(R"({"a":{}})", append), Catch::StartsWith("/a: "));
  CHECK_THAT(faultOf(R"({"a":"["})", append), Catch::StartsWith("/a: "));
  JsonChange inside;
  inside.member("a").element(2).member("b").set(1);
  CHECK_THAT(faultOf(R"({"a":[{},{}]})", inside), Catch::StartsWith("/a/2: "));
  CHECK_THAT(faultOf(R"({"a":[0,0,[]]})", inside), Catch::StartsWith("/a/2: "));
  CHECK_THAT(faultOf(R"({"a":[0,0,{}],"b":0,"a":[]})", inside), Catch::Contains("twice"));
  CHECK_THAT(faultOf("[]", inside), Catch::Contains("not an object"));
}
