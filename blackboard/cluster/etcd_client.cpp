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

std::size_t take_answer(char* bytes, std::size_t, std::size_t size, void* into) {
  auto& answer = *static_cast<std::string*>(into);
  if (answer.size() + size > most_answer_bytes) return 0;
  answer.append(bytes, size);
  return size;
}

std::string file_in(const std::string& folder, const char* name) { return folder + "/" + name; }

}  // namespace

class EtcdClient::Connection {
 public:
  explicit Connection(const std::string& certificates) : curl_(curl_easy_init()) {
    headers_ = curl_slist_append(nullptr, "Content-Type: application/json");
    // Without it curl asks first whether it may send a large body, and waits.
    headers_ = curl_slist_append(headers_, "Expect:");
    curl_easy_setopt(curl_, CURLOPT_HTTPHEADER, headers_);
    curl_easy_setopt(curl_, CURLOPT_NOSIGNAL, 1L);
    curl_easy_setopt(curl_, CURLOPT_TCP_NODELAY, 1L);
    curl_easy_setopt(curl_, CURLOPT_PROXY, "");
    curl_easy_setopt(curl_, CURLOPT_WRITEFUNCTION, take_answer);
    if (certificates.empty()) return;
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

  // Curl's own words where there is no answer.
  Result<long> post(const std::string& url, const std::string& body, Duration wait, std::string& answer) {
    curl_easy_setopt(curl_, CURLOPT_URL, url.c_str());
    curl_easy_setopt(curl_, CURLOPT_POSTFIELDS, body.data());
    curl_easy_setopt(curl_, CURLOPT_POSTFIELDSIZE, static_cast<long>(body.size()));
    curl_easy_setopt(curl_, CURLOPT_WRITEDATA, &answer);
    curl_easy_setopt(curl_, CURLOPT_TIMEOUT_MS, static_cast<long>(wait / 1ms));
    curl_easy_setopt(curl_, CURLOPT_CONNECTTIMEOUT_MS, static_cast<long>(std::max<Duration>(wait / 2, 1ms) / 1ms));
    const CURLcode code = curl_easy_perform(curl_);
    if (code != CURLE_OK) return fail("unavailable", curl_easy_strerror(code));
    long status = 0;
    curl_easy_getinfo(curl_, CURLINFO_RESPONSE_CODE, &status);
    return status;
  }

 private:
  CURL* const curl_;
  curl_slist* headers_ = nullptr;
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

Result<std::string> EtcdClient::post(const char* path, const std::string& body, Duration wait) {
  if (!member_) member_ = own_member(address_.members);
  const std::string& member = address_.members[*member_];
  const char* scheme = address_.certificates.empty() ? "http" : "https";
  std::string answer;
  const Result<long> status = connection_->post(fmt::format("{}://{}{}", scheme, member, path), body, wait, answer);
  if (status && *status == http_ok) return answer;
  member_ = (*member_ + 1) % address_.members.size();
  const std::string why = status ? etcd_json::error_from(answer) : status.error().sentence;
  return fail("unavailable", fmt::format("the member {} of {}: {}", member, address_.text, why));
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

}  // namespace pizarra::cluster
