#include "blackboard/cluster/etcd_client.hpp"

#include <array>
#include <curl/curl.h>
#include <fmt/format.h>
#include <unistd.h>

#include "blackboard/cluster/etcd_json.hpp"
#include "blackboard/cluster/own_member.hpp"

namespace pizarra::cluster {

namespace {

constexpr std::size_t most_answer_bytes = std::size_t{256} << 20;
constexpr long http_ok = 200;
constexpr long http_too_many = 429;
constexpr const char* status_path = "/v3/maintenance/status";
constexpr std::uint64_t default_quota = std::uint64_t{2} << 30;  // etcd's own

std::size_t take_answer(char* bytes, std::size_t, std::size_t size, void* into) {
  auto& answer = *static_cast<std::string*>(into);
  if (answer.size() + size > most_answer_bytes) return 0;
  answer.append(bytes, size);
  return size;
}

double share_taken(const KeyValues::Space& space) {
  return static_cast<double>(space.taken) / static_cast<double>(space.most);
}

std::string file_in(const std::string& folder, const char* name) { return folder + "/" + name; }

// A member that speaks TLS alone closes the connection of a client that does not, without a word.
std::string why_no_answer(CURLcode code, bool encrypted, const char* details) {
  std::string why = curl_easy_strerror(code);
  if (code == CURLE_PEER_FAILED_VERIFICATION) return std::string("its certificate is not believed: ") + details;
  if (encrypted || code != CURLE_GOT_NOTHING) return why;
  return why + ": where it asks for TLS, name the folder of ca.crt, client.crt and client.key with --log-certificates";
}

}  // namespace

class EtcdClient::Connection {
 public:
  explicit Connection(const std::string& certificates) : curl_(curl_easy_init()), encrypted_(!certificates.empty()) {
    headers_ = curl_slist_append(nullptr, "Content-Type: application/json");
    // Without it curl asks first whether it may send a large body, and waits.
    headers_ = curl_slist_append(headers_, "Expect:");
    // With it, a member that asks for certificates writes a warning of each request into its log.
    headers_ = curl_slist_append(headers_, "Accept:");
    curl_easy_setopt(curl_, CURLOPT_HTTPHEADER, headers_);
    curl_easy_setopt(curl_, CURLOPT_ERRORBUFFER, details_.data());
    curl_easy_setopt(curl_, CURLOPT_NOSIGNAL, 1L);
    // With TLS, etcd's port between members offers HTTP/2 and does not answer it.
    curl_easy_setopt(curl_, CURLOPT_HTTP_VERSION, static_cast<long>(CURL_HTTP_VERSION_1_1));
    curl_easy_setopt(curl_, CURLOPT_TCP_NODELAY, 1L);
    curl_easy_setopt(curl_, CURLOPT_PROXY, "");
    curl_easy_setopt(curl_, CURLOPT_WRITEFUNCTION, take_answer);
    if (!encrypted_) return;
    curl_easy_setopt(curl_, CURLOPT_CAINFO, file_in(certificates, "ca.crt").c_str());
    curl_easy_setopt(curl_, CURLOPT_SSLCERT, file_in(certificates, "client.crt").c_str());
    curl_easy_setopt(curl_, CURLOPT_SSLKEY, file_in(certificates, "client.key").c_str());
  }
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;
  ~Connection() {
    curl_easy_cleanup(curl_);
    curl_slist_free_all(headers_);
  }

  // Curl's own words where there is no answer. Without a body it only reads.
  Result<long> perform(const std::string& url, const std::string* body, Duration wait, std::string& answer) {
    curl_easy_setopt(curl_, CURLOPT_URL, url.c_str());
    if (body == nullptr) {
      curl_easy_setopt(curl_, CURLOPT_HTTPGET, 1L);
    } else {
      curl_easy_setopt(curl_, CURLOPT_POSTFIELDS, body->data());
      curl_easy_setopt(curl_, CURLOPT_POSTFIELDSIZE, static_cast<long>(body->size()));
    }
    curl_easy_setopt(curl_, CURLOPT_WRITEDATA, &answer);
    curl_easy_setopt(curl_, CURLOPT_TIMEOUT_MS, static_cast<long>(wait / 1ms));
    curl_easy_setopt(curl_, CURLOPT_CONNECTTIMEOUT_MS, static_cast<long>(std::max<Duration>(wait / 2, 1ms) / 1ms));
    const CURLcode code = curl_easy_perform(curl_);
    if (code != CURLE_OK) {
      const bool distrusted = code == CURLE_PEER_FAILED_VERIFICATION;
      return fail("unavailable", why_no_answer(code, encrypted_, details_.data()),
                  distrusted ? Datum::symbol(bad_certificate) : Datum());
    }
    long status = 0;
    curl_easy_getinfo(curl_, CURLINFO_RESPONSE_CODE, &status);
    return status;
  }

 private:
  CURL* const curl_;
  const bool encrypted_;
  curl_slist* headers_ = nullptr;
  std::array<char, CURL_ERROR_SIZE> details_{};
};

Result<std::unique_ptr<EtcdClient>> EtcdClient::open(const LogAddress& address) {
  static const CURLcode ready = curl_global_init(CURL_GLOBAL_DEFAULT);
  if (ready != CURLE_OK) return fail("unavailable", curl_easy_strerror(ready));
  for (const char* name : {"ca.crt", "client.crt", "client.key"}) {
    const std::string file = file_in(address.certificates, name);
    if (!address.certificates.empty() && access(file.c_str(), R_OK) != 0) {
      return fail("bad-address", "the certificates of the log cannot be read: " + file);
    }
  }
  return std::unique_ptr<EtcdClient>(new EtcdClient(address));
}

EtcdClient::EtcdClient(const LogAddress& address)
    : address_(address), connection_(std::make_unique<Connection>(address.certificates)) {}

EtcdClient::~EtcdClient() = default;

std::size_t EtcdClient::answering_member() {
  if (!member_) member_ = own_member(address_.members);
  return *member_;
}

std::size_t EtcdClient::next_member() { return (answering_member() + 1) % address_.members.size(); }

Result<std::string> EtcdClient::ask(std::size_t number, const char* path, const std::optional<std::string>& body,
                                    Duration wait) {
  const std::string& member = address_.members[number];
  const char* scheme = address_.certificates.empty() ? "http" : "https";
  std::string answer;
  const Result<long> status =
      connection_->perform(fmt::format("{}://{}{}", scheme, member, path), body ? &*body : nullptr, wait, answer);
  if (status && *status == http_ok) return answer;
  const bool full = status && *status == http_too_many && etcd_json::error_from(answer).contains("space exceeded");
  const std::string why = full     ? "it has no space left, and takes nothing (alarm NOSPACE)"
                          : status ? etcd_json::error_from(answer)
                                   : status.error().sentence;
  return fail("unavailable", fmt::format("the member {} of {}: {}", member, address_.text, why),
              full     ? Datum::symbol(no_space)
              : status ? Datum()
                       : status.error().subject);
}

Result<std::string> EtcdClient::post(const char* path, const std::string& body, Duration wait) {
  const std::size_t member = answering_member();
  Result<std::string> answer = ask(member, path, body, wait);
  // Where there is no space, the others have none either.
  const bool others_may_answer = !answer && !lacks_space(answer.error());
  if (others_may_answer) member_ = next_member();
  return answer;
}

Result<KeyValues::Reply> EtcdClient::transact(const Transaction& transaction, Duration wait) {
  const Result<std::string> answer = post("/v3/kv/txn", etcd_json::request(transaction), wait);
  if (!answer) return fail(answer);
  return etcd_json::reply_from(*answer);
}

Result<std::vector<KeyValue>> EtcdClient::range(const Range& range, std::size_t most, Duration wait) {
  const Result<std::string> answer = post("/v3/kv/range", etcd_json::request(range, most), wait);
  if (!answer) return fail(answer);
  return etcd_json::range_from(*answer);
}

// A member says it among its figures, a line `NAME NUMBER` each.
std::uint64_t EtcdClient::quota(std::size_t member, Duration wait) {
  const Result<std::string> figures = ask(member, "/metrics", std::nullopt, wait);
  constexpr std::string_view name = "\netcd_server_quota_backend_bytes ";
  const std::size_t at = figures ? figures->find(name) : std::string::npos;
  if (at == std::string::npos) return default_quota;
  const double bytes = std::strtod(figures->c_str() + at + name.size(), nullptr);
  return bytes >= 1 ? static_cast<std::uint64_t>(bytes) : default_quota;
}

Result<KeyValues::Space> EtcdClient::space_of(std::size_t member, Duration wait) {
  const Result<std::string> answer = ask(member, status_path, "{}", wait);
  if (!answer) return fail(answer);
  Result<Space> space = etcd_json::space_from(*answer);
  if (!space) return space;
  space->most = quota(member, wait);
  space->member = address_.members[member];
  return space;
}

// Any member lists the alarms of all, but knows its own file and quota alone.
Result<KeyValues::Space> EtcdClient::space(Duration wait) {
  const std::size_t first = answering_member();
  Result<Space> space = space_of(first, wait);
  if (!space) member_ = next_member();
  const bool is_settled = !space || !space->refuses;
  if (is_settled) return space;
  for (std::size_t member = 0; member < address_.members.size(); ++member) {
    if (member == first) continue;
    Result<Space> other = space_of(member, wait);
    if (other && share_taken(*other) > share_taken(*space)) space = std::move(other);
  }
  space->refuses = true;
  return space;
}

Result<void> EtcdClient::forget_former(Duration wait) {
  const Result<std::string> status = post(status_path, "{}", wait);
  if (!status) return fail(status);
  const Result<std::string> revision = etcd_json::revision_from(*status);
  if (!revision) return fail(revision);
  const Result<std::string> done = ask(answering_member(), "/v3/kv/compaction", etcd_json::compaction(*revision), wait);
  const bool was_done = !done && done.error().sentence.contains("has been compacted");
  return done || was_done ? Result<void>() : fail(done);
}

// Each member has a file of its own. A member that cannot close its holes now does not keep the others from it.
Result<void> EtcdClient::close_holes(Duration wait) {
  Result<void> all;
  for (std::size_t member = 0; member < address_.members.size(); ++member) {
    const Result<std::string> done = ask(member, "/v3/maintenance/defragment", "{}", wait);
    if (!done) all = fail(done);
  }
  return all;
}

Result<void> EtcdClient::end_refusing(Duration wait) {
  const Result<std::string> alarms = post("/v3/maintenance/alarm", R"({"action": "GET"})", wait);
  if (!alarms) return fail(alarms);
  const Result<std::vector<std::string>> requests = etcd_json::disarming(*alarms);
  if (!requests) return fail(requests);
  for (const std::string& request : *requests) {
    const Result<std::string> done = post("/v3/maintenance/alarm", request, wait);
    if (!done) return fail(done);
  }
  return {};
}

Result<std::string> EtcdClient::read(std::size_t member, const char* path, Duration wait) {
  return ask(member, path, std::nullopt, wait);
}

Result<void> EtcdClient::order(const char* path, const std::string& body, Duration wait) {
  const Result<std::string> done = post(path, body, wait);
  return done ? Result<void>() : fail(done);
}

}  // namespace pizarra::cluster
