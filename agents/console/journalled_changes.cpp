#include "agents/console/journalled_changes.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <string_view>

#include "blackboard/journal/journal_file.hpp"

namespace pizarra::console {

namespace {

// From its beginning, or from where compaction has left it.
Result<journal::PlayedBack> lines_of(const std::string& journal) {
  store::Store from_zero;
  Result<journal::PlayedBack> played = journal::read_journal(journal, from_zero, {.revision = 0});
  const bool later = !played && played.error().symbol == "forgotten" && played.error().subject.is_integer();
  if (!later) return played;
  store::Store left;
  return journal::read_journal(journal, left, {.revision = static_cast<Revision>(played.error().subject.integer())});
}

class Reader {
 public:
  KeptChanges::Kept kept;

  // Most lines are of other facts, and are not read. Of what goes a line says the id alone.
  void take(std::string_view line) {
    const auto has = [line](std::string_view part) { return line.find(part) != std::string_view::npos; };
    if (!has("(servo ") && !has("(tracked ") && !has(servo_goes_)) return;
    const auto read = journal::read_journal_line(line);
    const auto* commit = read ? std::get_if<store::Commit>(&*read) : nullptr;
    if (commit != nullptr) take(*commit, has(servo_goes_));
  }

 private:
  void take(const store::Commit& commit, bool servo_goes) {
    std::vector<Fact> servo;
    for (const store::Commit::Entry& entry : commit.entries) {
      if (!store::adds(entry)) continue;
      if (entry.fact.datum.is_form("servo")) servo.push_back(entry.fact);
      if (entry.fact.datum.is_form("tracked")) kept.take_sighting(entry.fact);
    }
    if (servo.empty() && !servo_goes) return;
    kept.take_servo(servo);
    servo_goes_ = servo.empty() ? nothing : fmt::format("(retract {})", servo.back().id);
  }

  static constexpr std::string_view nothing = "(retract nothing)";
  std::string servo_goes_{nothing};
};

}  // namespace

KeptChanges::Kept journalled_changes(const std::string& journal, const std::function<bool()>& is_cancelled) {
  Reader reader;
  const Result<journal::PlayedBack> played = lines_of(journal);
  if (!played) return reader.kept;
  std::string_view lines = played->later;
  while (!lines.empty() && !is_cancelled()) {
    const std::string_view line = lines.substr(0, lines.find('\n'));
    lines.remove_prefix(std::min(line.size() + 1, lines.size()));
    reader.take(line);
  }
  return reader.kept;
}

}  // namespace pizarra::console
