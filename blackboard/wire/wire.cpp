#include "blackboard/wire/wire.hpp"

#include <charconv>
#include <fmt/format.h>

#include "blackboard/limits.hpp"
#include "lisp/writer.hpp"

namespace pizarra::wire {

namespace {

constexpr ReadLimits frame_limits = {
    .bytes = limits::frame_bytes, .depth = limits::frame_depth, .elements = limits::frame_elements};

std::unexpected<Failure> bad_frame(const char* sentence, const Datum& form) {
  return fail("bad-frame", sentence, form);
}

Result<Transaction::Precondition> precondition_from_datum(const Datum& form) {
  if (form.is_form("present") && form.size() == 2) return Transaction::Present{form[1]};
  if (form.is_form("absent") && form.size() == 2) return Transaction::Absent{form[1]};
  if (form.is_form("unchanged") && form.size() == 3) {
    if (const auto revision = count_from(form[2])) return Transaction::Unchanged{form[1], *revision};
  }
  return bad_frame("not a precondition", form);
}

Result<Transaction::Step> step_from_datum(const Datum& form) {
  if (form.is_form("retract") && form.size() == 2) return Transaction::Retract{form[1]};
  if (form.is_form("settle") && form.size() == 2) {
    if (const auto taken = count_from(form[1])) return Transaction::Settle{*taken};
  }
  if (form.is_form("tell") && form.size() >= 3) {
    const std::optional<std::uint64_t> lease = count_from(form[2]);
    Result<std::vector<FactId>> because = ids_from(form.items().subspan(3));
    if (!because) return fail(because);
    if (lease) return Transaction::Tell{form[1], std::move(*because), *lease};
  }
  return bad_frame("not a step of a transaction", form);
}

// Each precondition and step as a form, one after another.
struct TransactionWriter {
  explicit TransactionWriter(std::string& text) : out(text) {}

  void operator()(const Transaction::Present& present) { write_form("(present ", present.pattern); }
  void operator()(const Transaction::Absent& absent) { write_form("(absent ", absent.pattern); }
  void operator()(const Transaction::Unchanged& unchanged) {
    write_form("(unchanged ", unchanged.pattern);
    add_number(unchanged.revision);
  }
  void operator()(const Transaction::Tell& tell) {
    write_form("(tell ", tell.fact);
    add_number(tell.lease);
    for (const FactId cause : tell.because) add_number(cause);
  }
  void operator()(const Transaction::Retract& retract) { write_form("(retract ", retract.pattern); }
  void operator()(const Transaction::Settle& settle) {
    out += "(settle)";
    add_number(settle.taken);
  }

  std::string& out;
  Weight weight;

 private:
  void write_form(std::string_view head, const Datum& datum) {
    out += head;
    write_to(out, datum);
    out += ')';
    weight += weigh(datum);
    weight.elements += 2;
  }
  // Into the form that was written last.
  void add_number(std::uint64_t number) {
    out.back() = ' ';
    write_number_to(out, number);
    out += ')';
    ++weight.elements;
  }
};

}  // namespace

Result<void> check_protocol(std::uint64_t of_client) {
  if (of_client + 1 >= protocol && of_client <= protocol + 1) return {};
  return fail(
      "other-protocol",
      fmt::format("the client speaks protocol {} and the board protocol {}, more than one apart: bring the {} up "
                  "to date",
                  of_client, protocol, of_client < protocol ? "client" : "board"),
      to_datum(of_client));
}

Result<Datum> read_frame(std::string_view text) { return read_one(text, frame_limits, "frame"); }

Result<std::vector<Datum>> read_messages(std::string_view frame) {
  Result<std::vector<Datum>> messages = read_all(frame, frame_limits, "frame");
  if (!messages || messages->size() <= most_messages) return messages;
  return fail("too-many", "a frame holds at most " + std::to_string(most_messages) + " messages");
}

std::optional<RequestId> request_begun(std::string_view frame, SessionId session) {
  const std::string begin = "(request " + std::to_string(session) + ' ';
  if (!frame.starts_with(begin)) return std::nullopt;
  frame.remove_prefix(begin.size());
  std::int64_t number = 0;
  const auto read = std::from_chars(frame.data(), frame.data() + frame.size(), number);
  const bool whole = read.ec == std::errc() && read.ptr != frame.data() + frame.size() && *read.ptr == ' ';
  if (!whole || number < 0) return std::nullopt;
  return static_cast<RequestId>(number);
}

std::optional<std::uint64_t> count_from(const Datum& datum) {
  if (!datum.is_integer() || datum.integer() < 0) return std::nullopt;
  return static_cast<std::uint64_t>(datum.integer());
}

std::optional<std::uint64_t> count_at(const Datum& form, std::size_t index) {
  if (index >= form.size()) return std::nullopt;
  return count_from(form[index]);
}

Result<std::vector<FactId>> ids_from(std::span<const Datum> forms) {
  std::vector<FactId> ids;
  for (const Datum& form : forms) {
    const std::optional<std::uint64_t> id = count_from(form);
    if (!id) return bad_frame("a cause is the id of a fact", form);
    ids.push_back(*id);
  }
  return ids;
}

Weight write_transaction(std::string& out, const Transaction& transaction) {
  TransactionWriter writer(out);
  out += "(transact (";
  for (const auto& precondition : transaction.preconditions) std::visit(writer, precondition);
  out += ") (";
  for (const Transaction::Step& step : transaction.steps) std::visit(writer, step);
  out += "))";
  return writer.weight;
}

Result<Transaction> transaction_from_datum(const Datum& body) {
  if (body.size() != 3 || !body[1].is_list() || !body[2].is_list()) return bad_frame("not a transaction", body);
  Transaction transaction;
  for (const Datum& form : body[1].items()) {
    Result<Transaction::Precondition> precondition = precondition_from_datum(form);
    if (!precondition) return fail(precondition);
    transaction.preconditions.push_back(std::move(*precondition));
  }
  transaction.steps.reserve(body[2].size());
  for (const Datum& form : body[2].items()) {
    Result<Transaction::Step> step = step_from_datum(form);
    if (!step) return fail(step);
    transaction.steps.push_back(std::move(*step));
  }
  return transaction;
}

}  // namespace pizarra::wire
