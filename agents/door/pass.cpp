#include "agents/door/pass.hpp"

#include <filesystem>

#include "lisp/plain_name.hpp"

namespace pizarra::door {

namespace {

std::unexpected<Failure> nobody() { return fail("not-permitted", "nobody comes with this name and this token"); }

// In a time that does not say where they differ.
bool is_same(std::string_view secret, std::string_view shown) {
  unsigned difference = secret.size() == shown.size() ? 0 : 1;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    difference |= static_cast<unsigned char>(shown[i]) ^ static_cast<unsigned char>(secret[i % secret.size()]);
  }
  return difference == 0;
}

std::unexpected<Failure> may_not(const Pass& pass, std::string_view verb, std::string_view relation) {
  return fail("not-permitted",
              pass.name + " may not " + std::string(verb) + (relation.empty() ? " this" : " " + std::string(relation)));
}

}  // namespace

Result<void> Pass::may_declare(const Datum& relation) const {
  const std::string_view called = relation.size() > 1 ? relation[1].text() : std::string_view();
  for (const auto* listed : {&may.tell, &may.take, &may.read}) {
    if (wire::permits(*listed, called)) return {};
  }
  return may_not(*this, "declare", called);
}

Result<void> Pass::may_tell(const Datum& fact) const {
  if (wire::permits(may.tell, fact.head())) return {};
  return may_not(*this, "tell or retract", fact.head());
}

Result<void> Pass::may_read(const Query& query) const {
  for (const Query::Clause& clause : query.clauses) {
    const bool of_facts = clause.kind != Query::Clause::Kind::compare;
    if (of_facts && !wire::permits(may.read, clause.form.head())) return may_not(*this, "read", clause.form.head());
  }
  return {};
}

Result<Pass> pass_of(const std::string& folder, const std::string& name, std::string_view token) {
  if (!is_plain_name(name) || name == wire::board_key_name) return nobody();
  const std::string base = folder + "/" + name;
  std::error_code unknown;
  if (!std::filesystem::exists(base + ".secret", unknown)) return nobody();
  const Result<wire::KeyPair> secret = wire::read_secret_key(base + ".secret");
  if (!secret) return fail(secret);
  if (!is_same(secret->secret_key, token)) return nobody();
  Result<wire::PublicKey> shown = wire::read_public_key(base + ".key");
  if (!shown) return fail(shown);
  if (secret->name != name || shown->name != name || shown->key != secret->public_key) {
    return fail("bad-key", name + ".secret and " + name + ".key are not the two halves of a key of this name");
  }
  Pass pass{name, std::move(shown->may), std::nullopt};
  if (!std::filesystem::exists(folder + "/board.key", unknown)) return pass;
  Result<wire::ClientKeys> keys = wire::read_client_keys(base + ".secret");
  if (!keys) return fail(keys);
  pass.keys = std::move(*keys);
  return pass;
}

}  // namespace pizarra::door
