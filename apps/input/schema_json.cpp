/// @file
/// JSON Schema of scenes, studies, batches and comparisons, for editors.
#include <fmt/format.h>
#include <toml++/toml.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "apps/input/schema.hpp"

namespace liesl {

namespace {

using Json = nlohmann::ordered_json;

Json bounded(const Key& key, const char* type) {
  Json json = {{"type", type}};
  if (std::isfinite(key.range.lower))
    json[key.range.open_lower ? "exclusiveMinimum" : "minimum"] = key.range.lower;
  if (std::isfinite(key.range.upper))
    json[key.range.open_upper ? "exclusiveMaximum" : "maximum"] = key.range.upper;
  return json;
}

Json list_of(const Json& item, int least, int most = -1) {
  Json json = {{"type", "array"}, {"items", item}, {"minItems", least}};
  if (most >= 0) json["maxItems"] = most;
  return json;
}

class SchemaWriter {
 public:
  explicit SchemaWriter(FileKind kind) : kind_(kind) {}

  /// A table with the keys below a pattern.
  Json object(std::string_view pattern) const {
    Json json = {{"type", "object"}};
    std::map<std::string, Json> variants;  // of keys that depend on others: several of one name
    std::vector<std::string> order;
    Json required = Json::array(), one_of = Json::array(), conditions = Json::array();
    json["additionalProperties"] = false;
    for (const Key* key : children(kind_, pattern)) {
      const std::string name(key->leaf());
      if (name == "*") {
        json["additionalProperties"] = value(*key);
        continue;
      }
      if (!variants.contains(name)) order.push_back(name);
      variants.try_emplace(name, Json::array()).first->second.push_back(value(*key));
      if (key->preset == kOneOf) one_of.push_back({{"required", {name}}});
      if (key->preset == kRequired && key->when.empty()) required.push_back(name);
      if (key->preset == kRequired && !key->when.empty())
        conditions.push_back(condition(*key, name));
    }
    for (const std::string& name : order) {
      const Json& all = variants[name];
      json["properties"][name] = all.size() == 1 ? all[0] : Json{{"anyOf", all}};
    }
    if (!required.empty()) json["required"] = required;
    if (!one_of.empty()) json["oneOf"] = one_of;
    if (!conditions.empty()) json["allOf"] = conditions;
    return json;
  }

 private:
  /// "type=circle tube": needed if the sibling has such a value.
  static Json condition(const Key& key, const std::string& name) {
    const auto equals = key.when.find('=');
    const std::string sibling(key.when.substr(0, equals));
    const Json chosen = {
        {"properties", {{sibling, {{"enum", words(key.when.substr(equals + 1))}}}}},
        {"required", {sibling}}};
    return {{"if", chosen}, {"then", {{"required", {name}}}}};
  }

  Json value(const Key& key) const {
    Json json = plain(key);
    std::string doc = key.doc;
    if (!key.unit.empty() && key.unit != "-") doc += fmt::format(" [{}]", key.unit);
    if (!doc.empty()) json["description"] = doc;
    const bool preset = key.preset != kRequired && key.preset != kOptional && key.preset != kOneOf;
    if (preset) {
      const toml::table table = toml::parse(fmt::format("v = {}", key.preset));
      const toml::node& v = *table.get("v");
      if (const auto text = v.value<std::string>(); v.is_string()) json["default"] = *text;
      if (v.is_boolean()) json["default"] = *v.value<bool>();
      if (v.is_number()) json["default"] = *v.value<double>();
    }
    return json;
  }

  Json plain(const Key& key) const {
    const Json number = bounded(key, "number"), text = {{"type", "string"}};
    const int n = key.size;
    switch (key.type) {
      case Type::Text:
        return text;
      case Type::Choice:
        return {{"enum", words(key.options)}};
      case Type::Boolean:
        return {{"type", "boolean"}};
      case Type::Integer:
        return bounded(key, "integer");
      case Type::Number:
        return number;
      case Type::Vector:
        return list_of(number, n, n);
      case Type::Point:
        return list_of(number, 2, 3);
      case Type::NumberOrList:
        return {{"anyOf", {number, n > 0 ? list_of(number, n, n) : list_of(number, 1)}}};
      case Type::Rows:
        return list_of(list_of(number, n, n), 2);
      case Type::NumberOrMatrix:
        return {
            {"anyOf",
             {number, list_of(number, n, n), list_of(list_of({{"type", "number"}}, n, n), n, n)}}};
      case Type::Matrix:
        return list_of({{"anyOf", {number, list_of(number, n, n)}}}, n, n == 3 ? 6 : n);
      case Type::Texts:
        return {{"anyOf", {text, list_of(text, 1)}}};
      case Type::Pair:
        return list_of(text, 2, 2);
      case Type::Function:
        return {{"anyOf", {number, text, {{"$ref", "#/$defs/function"}}}}};
      case Type::List:
        return list_of(Json::object(), 1);
      case Type::Any:
        return Json::object();
      case Type::TableOrList:
        return {{"anyOf", {object(key.path), list_of(object(key.path), 1)}}};
      case Type::Table:
      case Type::Named:
        break;
    }
    return object(key.path);
  }

  FileKind kind_;
};

}  // namespace

std::string schema_json(FileKind kind) {
  const SchemaWriter writer(kind);
  Json json = {{"$schema", "http://json-schema.org/draft-07/schema#"},
               {"title", fmt::format("{} of liesl", name_of(kind))}};
  json.update(writer.object(""));
  if (!children(kind, "(function)").empty())
    json["$defs"]["function"] = writer.object("(function)");
  json["properties"].erase("(function)");
  return json.dump(2) + "\n";
}

}  // namespace liesl
