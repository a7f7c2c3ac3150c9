#include "blackboard/cluster/etcd_json.hpp"

#include <algorithm>
#include <charconv>
#include <nettle/base64.h>
#include <nlohmann/json.hpp>

#include "lisp/outside_text.hpp"

namespace pizarra::cluster::etcd_json {

namespace {

using nlohmann::json;

std::string encoded(const std::string& bytes) {
  std::string text(BASE64_ENCODE_RAW_LENGTH(bytes.size()), '\0');
  base64_encode_raw(text.data(), bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
  return text;
}

std::optional<std::string> decoded(const json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end()) return std::string();
  if (!found->is_string()) return std::nullopt;
  const std::string& text = found->get_ref<const std::string&>();
  std::string bytes(BASE64_DECODE_LENGTH(text.size()), '\0');
  base64_decode_ctx context;
  base64_decode_init(&context);
  std::size_t size = bytes.size();
  const bool sound = base64_decode_update(&context, &size, reinterpret_cast<std::uint8_t*>(bytes.data()), text.size(),
                                          text.data()) != 0;
  if (!sound || base64_decode_final(&context) == 0) return std::nullopt;
  bytes.resize(size);
  return bytes;
}

json range_json(const KeyValues::Range& range) {
  return {{"key", encoded(range.from)}, {"range_end", encoded(range.to)}};
}

json compare_json(const KeyValues::Compare& compare) {
  json form = {{"key", encoded(compare.key)}, {"result", "EQUAL"}};
  if (compare.value) {
    form["target"] = "VALUE";
    form["value"] = encoded(*compare.value);
  } else {
    form["target"] = "CREATE";
    form["create_revision"] = "0";
  }
  return form;
}

std::unexpected<Failure> not_understood() { return fail("unavailable", "etcd gave an answer that is not understood"); }

bool is_list_of_objects(const json& list) {
  return list.is_array() && std::ranges::all_of(list, [](const json& each) { return each.is_object(); });
}

bool is_list_of_texts(const json& list) {
  return list.is_array() && std::ranges::all_of(list, [](const json& each) { return each.is_string(); });
}

bool add_found(const json& response, std::vector<KeyValue>& found) {
  if (!response.is_object()) return false;
  const auto values = response.find("kvs");
  if (values == response.end()) return true;
  if (!is_list_of_objects(*values)) return false;
  for (const json& value : *values) {
    std::optional<std::string> key = decoded(value, "key");
    std::optional<std::string> text = decoded(value, "value");
    if (!key || !text) return false;
    found.push_back({std::move(*key), std::move(*text)});
  }
  return true;
}

std::optional<json> object_from(const std::string& body) {
  json read = json::parse(body, nullptr, false);
  if (!read.is_object()) return std::nullopt;
  return read;
}

// Etcd writes large numbers as strings.
std::optional<std::uint64_t> count_from(const json& object, const char* name) {
  const auto found = object.find(name);
  if (found == object.end() || !found->is_string()) return std::nullopt;
  const std::string& text = found->get_ref<const std::string&>();
  std::uint64_t count = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), count);
  if (read.ec != std::errc() || read.ptr != text.data() + text.size()) return std::nullopt;
  return count;
}

}  // namespace

std::string request(const KeyValues::Transaction& transaction) {
  json form = {{"compare", json::array()}, {"success", json::array()}, {"failure", json::array()}};
  for (const KeyValues::Compare& compare : transaction.compares) {
    form["compare"].push_back(compare_json(compare));
    form["failure"].push_back({{"request_range", {{"key", encoded(compare.key)}}}});
  }
  for (const KeyValues::Range& range : transaction.deletes) {
    form["success"].push_back({{"request_delete_range", range_json(range)}});
  }
  for (const KeyValue& put : transaction.puts) {
    form["success"].push_back({{"request_put", {{"key", encoded(put.key)}, {"value", encoded(put.value)}}}});
  }
  return form.dump();
}

std::string request(const KeyValues::Range& range, std::size_t most) {
  json form = range_json(range);
  form["limit"] = std::to_string(most);
  return form.dump();
}

Result<KeyValues::Reply> reply_from(const std::string& body) {
  const std::optional<json> form = object_from(body);
  if (!form || !form->contains("header")) return not_understood();
  KeyValues::Reply reply;
  const json succeeded = form->value("succeeded", json(false));
  if (!succeeded.is_boolean()) return not_understood();
  reply.succeeded = succeeded.get<bool>();
  if (reply.succeeded) return reply;
  const json responses = form->value("responses", json::array());
  if (!is_list_of_objects(responses)) return not_understood();
  for (const json& response : responses) {
    const auto range = response.find("response_range");
    if (range != response.end() && !add_found(*range, reply.found)) return not_understood();
  }
  return reply;
}

Result<std::vector<KeyValue>> range_from(const std::string& body) {
  const std::optional<json> form = object_from(body);
  std::vector<KeyValue> found;
  if (!form || !form->contains("header") || !add_found(*form, found)) return not_understood();
  return found;
}

Result<KeyValues::Space> space_from(const std::string& body) {
  const std::optional<json> form = object_from(body);
  const std::optional<std::uint64_t> taken = form ? count_from(*form, "dbSize") : std::nullopt;
  if (!taken) return not_understood();
  KeyValues::Space space{.taken = *taken};
  const auto errors = form->find("errors");
  if (errors == form->end() || !errors->is_array()) return space;
  space.refuses = std::ranges::any_of(*errors, [](const json& error) {
    return error.is_string() && error.get_ref<const std::string&>().contains("NOSPACE");
  });
  return space;
}

Result<std::string> revision_from(const std::string& body) {
  const std::optional<json> form = object_from(body);
  const auto header = form ? form->find("header") : json::const_iterator();
  const bool has_one = form && header != form->end() && header->is_object() && count_from(*header, "revision");
  if (!has_one) return not_understood();
  return (*header)["revision"].get<std::string>();
}

std::string compaction(const std::string& revision) {
  return json({{"revision", revision}, {"physical", true}}).dump();
}

Result<std::vector<std::string>> disarming(const std::string& body) {
  const std::optional<json> form = object_from(body);
  if (!form) return not_understood();
  std::vector<std::string> requests;
  const json alarms = form->value("alarms", json::array());
  if (!is_list_of_objects(alarms)) return not_understood();
  for (const json& alarm : alarms) {
    const json kind = alarm.value("alarm", json("NONE"));
    if (!kind.is_string()) return not_understood();
    const bool is_one = alarm.contains("memberID") && kind == "NOSPACE";
    if (!is_one) continue;
    requests.push_back(json({{"action", "DEACTIVATE"}, {"memberID", alarm["memberID"]}, {"alarm", "NOSPACE"}}).dump());
  }
  return requests;
}

Result<std::vector<LogMember>> members_from(const std::string& body) {
  const json form = json::parse(body, nullptr, false);
  if (!form.is_array()) return not_understood();
  std::vector<LogMember> members;
  for (const json& each : form) {
    const bool sound = each.is_object() && each.contains("id") && each["id"].is_number_unsigned();
    if (!sound) return not_understood();
    LogMember member{.id = each["id"].get<std::uint64_t>()};
    const json urls = each.value("peerURLs", json::array());
    if (!is_list_of_texts(urls)) return not_understood();
    if (!urls.empty()) member.peer_url = urls.front().get<std::string>();
    member.was_added = !each.contains("name") || each["name"] == "";
    member.has_run = each.contains("clientURLs") && !each["clientURLs"].empty();
    members.push_back(std::move(member));
  }
  return members;
}

std::string removal(std::uint64_t member) { return json({{"ID", std::to_string(member)}}).dump(); }

std::string addition(const std::string& peer_url) { return json({{"peerURLs", json::array({peer_url})}}).dump(); }

std::string error_from(const std::string& body) {
  const std::optional<json> form = object_from(body);
  constexpr std::size_t longest = 200;
  const bool said = form && form->contains("error") && (*form)["error"].is_string();
  const std::string error = said ? (*form)["error"].get<std::string>() : body;
  return text_of_bytes(error.substr(0, std::min(longest, error.find_last_not_of('\n') + 1)));
}

std::string news_from(const std::string& log_line) {
  const std::optional<json> form = object_from(log_line);
  if (!form || !form->contains("msg") || !(*form)["msg"].is_string()) return log_line;
  const std::string news = (*form)["msg"].get<std::string>();
  return text_of_bytes(form->contains("error") ? news + ": " + error_from(log_line) : news);
}

}  // namespace pizarra::cluster::etcd_json
