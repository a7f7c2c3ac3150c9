#include "agents/vision/database/object_database.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <fmt/format.h>
#include <sys/stat.h>

#include "agents/vision/database/object_schema.hpp"
#include "agents/vision/database/template_bitmap.hpp"
#include "agents/vision/objects/sample_facts.hpp"
#include "blackboard/journal/checksum.hpp"
#include "lisp/writer.hpp"

namespace pizarra::vision {
namespace {

constexpr const char* file_name = "objects.sqlite";

// The checksum of all that is kept of a sample, its bitmap included. Every format words what they have in common alike.
std::int64_t sum_of(const LearnedSample& sample) {
  const std::string nameless;
  const Datum facts = learned_template_fact(nameless, sample);
  std::vector<Datum> kept(facts.items().begin(), facts.items().end());
  if (sample.size_by == LearnedSample::SizeBy::measured) kept.erase(kept.end() - 2);
  journal::Checksum sum;
  sum.add(write(learned_fact(nameless, sample))).add(write(Datum::list(std::move(kept))));
  if (sample.focal_px > 0) sum.add(write(learned_focal_fact(nameless, sample)));
  if (sample.contrast > 0) sum.add(write(learned_print_fact(nameless, sample)));
  if (sample.axis_deg > 0) sum.add(write(learned_axis_fact(nameless, sample)));
  return sum.value();
}

bool makes_sense(const LearnedSample& s) {
  const std::array<double, 12> values = {s.area_px,   s.moments[0], s.moments[1], s.moments[2],
                                         s.height_px, s.slimness,   s.roundness,  s.roundness_spread,
                                         s.size_mm,   s.focal_px,   s.contrast,   s.axis_deg};
  return s.number > 0 && s.height_px > 0 && s.slimness > 0 && s.roundness > 0 && s.size_mm >= 0 && s.focal_px >= 0 &&
         s.contrast >= 0 && s.axis_deg >= 0 && s.axis_deg <= 180 &&
         std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

}  // namespace

Result<ObjectDatabase> ObjectDatabase::open(const std::string& directory) {
  std::error_code error;
  std::filesystem::create_directories(directory, error);
  if (error) {
    return fail("unusable", fmt::format("the folder of the objects cannot be made: {}", error.message()),
                to_datum(directory));
  }
  return open_prepared(directory, prepare_objects);
}

Result<ObjectDatabase> ObjectDatabase::open_again(const std::string& directory) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(std::filesystem::path(directory) / file_name, error)) {
    return fail("missing", "the folder has no database of learned objects", to_datum(directory));
  }
  return open_prepared(directory, prepare_objects_again);
}

Result<ObjectDatabase> ObjectDatabase::open_prepared(const std::string& directory,
                                                     Result<void> (*prepare)(journal::sqlite::Database&)) {
  const std::filesystem::path file = std::filesystem::path(directory) / file_name;
  Result<journal::sqlite::Database> database =
      journal::sqlite::Database::open(file.string(), journal::sqlite::Access::write);
  if (!database) return fail(database);
  const Result<void> prepared = prepare(*database);
  if (!prepared) return fail(prepared);
  ObjectDatabase out(directory, std::move(*database));
  out.file_ = out.file_now();
  return out;
}

ObjectDatabase::FileId ObjectDatabase::file_now() const {
  struct stat found {};
  if (::stat((directory_ / file_name).c_str(), &found) != 0) return std::nullopt;
  return std::pair<std::uint64_t, std::uint64_t>(found.st_dev, found.st_ino);
}

std::filesystem::path ObjectDatabase::bitmap(const Row& row) const {
  return directory_ / fmt::format("{}-{}.pgm", row.name, row.number);
}

Result<KeptObjects> ObjectDatabase::read() {
  KeptObjects out;
  bitmaps_.clear();
  journal::sqlite::Statement rows(
      database_,
      "SELECT name, num, tone, area, perimeter, nf, m0, m1, m2, height, slimness, roundness, "
      "roundness_spread, size, sum, id, size_by, focal, contrast, axis FROM samples ORDER BY id");
  for (Result<bool> row = rows.step(); !row || *row; row = rows.step()) {
    if (!row) return fail(row);
    const std::string name(rows.text(0));
    // It might lead to a file anywhere.
    if (!check_object_name(name)) {
      const std::string place = fmt::format("{}, row {}", file_name, rows.integer(15));
      out.damaged.push_back({name, {"damaged", "the name in this row is none of an object", to_datum(place), {}}});
      continue;
    }
    const std::filesystem::path file = bitmap({name, rows.integer(1)});
    bitmaps_.note(file);
    Result<LearnedSample> sample = sample_of(rows, name);
    const Result<LearnedObjects::Slot> room = sample ? out.objects.slot_for(name) : fail(sample);
    if (room) {
      out.objects.add(room->name, std::move(*sample));
    } else {
      Failure why = room.error();
      why.subject = to_datum(file.filename().string());
      out.damaged.push_back({name, std::move(why)});
    }
  }
  return out;
}

Result<LearnedSample> ObjectDatabase::sample_of(journal::sqlite::Statement& row, const std::string& name) const {
  LearnedSample out;
  out.number = static_cast<int>(row.integer(1));
  set_tone(out, row.text(2));
  out.area_px = row.real(3);
  out.perimeter_px = static_cast<int>(row.integer(4));
  out.corners = static_cast<int>(row.integer(5));
  out.moments = {row.real(6), row.real(7), row.real(8)};
  out.height_px = row.real(9);
  out.slimness = row.real(10);
  out.roundness = row.real(11);
  out.roundness_spread = row.real(12);
  out.size_mm = row.real(13);
  out.id = row.integer(15);
  out.size_by = static_cast<LearnedSample::SizeBy>(std::clamp<std::int64_t>(row.integer(16), 0, 3));
  out.focal_px = row.real(17);
  out.contrast = row.real(18);
  out.axis_deg = row.real(19);
  const Result<MarkTemplate> picture = read_bitmap(bitmap({name, out.number}), out.tone);
  if (!picture) return fail(picture);
  out.set_picture(*picture);
  if (!makes_sense(out) || sum_of(out) != row.integer(14)) {
    return fail("damaged", "the sample's row and its bitmap do not belong together: one of them is damaged");
  }
  return out;
}

Result<std::int64_t> ObjectDatabase::apply(const ObjectChange& change_wanted) {
  Outcome outcome;
  {
    journal::sqlite::Transaction transaction(database_);
    const Result<void> begun = transaction.begin();
    if (!begun) return fail(begun);
    Result<void> done = std::visit([&](const auto& wanted) { return change(wanted, outcome); }, change_wanted);
    if (done) done = transaction.commit();
    // Nobody else writes before the transaction has ended.
    std::error_code ignored;
    for (const Row& row : outcome.written) {
      if (!done) std::filesystem::remove(bitmap(row), ignored);
    }
    if (!done) return fail(done);
  }
  remove(outcome.left_over);
  return outcome.kept;
}

// Another agent may have given the number, and so the file, to a sample of its own meanwhile. A file that stays is
// overwritten by the next sample of its name.
void ObjectDatabase::remove(const Rows& bitmaps) {
  if (bitmaps.empty()) return;
  journal::sqlite::Transaction alone(database_);
  if (!alone.begin()) return;
  for (const Row& row : bitmaps) {
    journal::sqlite::Statement same(database_, "SELECT 1 FROM samples WHERE name = ? COLLATE BINARY AND num = ?");
    const Result<bool> used = same.bind(1, row.name).bind(2, row.number).step();
    std::error_code ignored;
    if (used && !*used) std::filesystem::remove(bitmap(row), ignored);
  }
}

Result<ObjectDatabase::Rows> ObjectDatabase::rows_of(const std::string& name) {
  const Result<void> named = check_object_name(name);
  if (!named) return fail(named);
  Rows out;
  journal::sqlite::Statement rows(database_, "SELECT name, num FROM samples WHERE name = ? ORDER BY num");
  rows.bind(1, name);
  for (Result<bool> row = rows.step(); !row || *row; row = rows.step()) {
    if (!row) return fail(row);
    out.push_back({std::string(rows.text(0)), rows.integer(1)});
  }
  return out;
}

Result<ObjectDatabase::Rows> ObjectDatabase::known_rows(const std::string& name) {
  Result<Rows> rows = rows_of(name);
  if (rows && rows->empty()) return fail("not-learned", "nothing is learned under this name", to_datum(name));
  return rows;
}

Result<void> ObjectDatabase::change(const KeepSample& keep, Outcome& outcome) {
  const Result<KeptObjects> now = read();
  if (!now) return fail(now);
  const Result<LearnedObjects::Slot> slot = now->objects.slot_for(keep.name);
  if (!slot) return fail(slot);
  const Result<Rows> known = rows_of(keep.name);
  if (!known) return fail(known);
  const std::string name = known->empty() ? slot->name : known->back().name;
  LearnedSample sample = keep.sample;
  // A damaged sample keeps its number.
  sample.number = known->empty() ? 1 : static_cast<int>(known->back().number) + 1;
  const std::string tone = tone_of(sample);
  journal::sqlite::Statement row(
      database_, "INSERT INTO samples VALUES (NULL, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)");
  row.bind(1, name).bind(2, std::int64_t{sample.number});
  row.bind(3, tone).bind_real(4, sample.area_px);
  row.bind(5, std::int64_t{sample.perimeter_px}).bind(6, std::int64_t{sample.corners});
  for (int i = 0; i < 3; ++i) row.bind_real(7 + i, sample.moments[static_cast<std::size_t>(i)]);
  row.bind_real(10, sample.height_px).bind_real(11, sample.slimness).bind_real(12, sample.roundness);
  row.bind_real(13, sample.roundness_spread).bind_real(14, sample.size_mm).bind(15, sum_of(sample));
  row.bind(16, static_cast<std::int64_t>(sample.size_by)).bind_real(17, sample.focal_px);
  row.bind_real(18, sample.contrast).bind_real(19, sample.axis_deg);
  const Result<void> inserted = row.run();
  if (!inserted) return inserted;
  const Result<std::int64_t> id = database_.ask("SELECT last_insert_rowid()");
  if (!id) return fail(id);
  outcome.kept = *id;
  const Result<void> drawn = write_bitmap(bitmap({name, sample.number}), sample.picture, sample.tone);
  if (drawn) outcome.written.push_back({name, sample.number});
  return drawn;
}

Result<void> ObjectDatabase::change(const WithdrawSample& withdraw, Outcome& outcome) {
  journal::sqlite::Statement row(database_, "DELETE FROM samples WHERE id = ? RETURNING name, num");
  const Result<bool> there = row.bind(1, withdraw.id).step();
  if (!there) return fail(there);
  if (!*there) return fail("not-learned", "this sample is not there any more", to_datum(withdraw.name));
  if (check_object_name(row.text(0))) outcome.left_over.push_back({std::string(row.text(0)), row.integer(1)});
  return row.run();
}

Result<void> ObjectDatabase::change(const ForgetObject& forget, Outcome& outcome) {
  const Result<Rows> rows = known_rows(forget.name);
  if (!rows) return fail(rows);
  journal::sqlite::Statement row(database_, "DELETE FROM samples WHERE name = ?");
  const Result<void> gone = row.bind(1, forget.name).run();
  if (gone) outcome.left_over = *rows;
  return gone;
}

Result<void> ObjectDatabase::change(const RenameObject& rename, Outcome& outcome) {
  const Result<Rows> rows = known_rows(rename.name);
  if (!rows) return fail(rows);
  const Result<Rows> others = rows_of(rename.new_name);
  if (!others) return fail(others);
  if (!others->empty() && !same_name(rename.name, rename.new_name)) return name_taken(rename.new_name);
  journal::sqlite::Statement row(database_, "UPDATE samples SET name = ? WHERE name = ?");
  const Result<void> renamed = row.bind(1, rename.new_name).bind(2, rename.name).run();
  if (!renamed) return renamed;
  for (const Row& each : *rows) {
    const Row to{rename.new_name, each.number};
    if (bitmap(each) == bitmap(to)) continue;
    const Result<void> copied = copy_bitmap(bitmap(each), bitmap(to));
    if (!copied) return copied;
    outcome.written.push_back(to);
    outcome.left_over.push_back(each);
  }
  return {};
}

}  // namespace pizarra::vision
