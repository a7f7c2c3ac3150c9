// A journal's lines, and a journal's file with some bytes of it changed: what recovers is a store that works.
//
// An input that begins with `!` says which bytes of a sound file to change: two bytes of offset and one of value, again
// and again, the last one or two bytes where to cut it off. Any other is the lines themselves.

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <unistd.h>

#include "blackboard/journal/journal.hpp"
#include "blackboard/journal/journal_file.hpp"
#include "blackboard/query.hpp"
#include "blackboard/store/store.hpp"
#include "lisp/reader.hpp"

using namespace pizarra;

namespace {

const std::string sound_lines =
    "(0 5 \"a\" (declare (relation goal ((n integer) (text datum)) (key n) (durable))))\n"
    "(1 6 \"a\" (tell 1 (goal 1 one)) (tell 2 (goal 2 (two))))\n"
    "(2 7 \"b\" (take 1) (retract 2) (tell 3 (goal 3 \"three\") (because 1)))\n";

void use(store::Store& store) {
  store.resume(Time(10s));
  for (const auto& [name, table] : store.tables()) {
    const Datum pattern = list(Datum::symbol(name), "?x"_sym, "?y"_sym);
    [[maybe_unused]] const Result<Answers> answers = store.ask(query_for(pattern));
  }
  Transaction transaction;
  transaction.tell(list("goal"_sym, 9, "nine"_sym)).retract(list("goal"_sym, "?"_sym, "?"_sym));
  [[maybe_unused]] const Result<Revision> revision = store.transact("fuzz", transaction, Time(10s));
}

std::string contents_of(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

std::string path_for(const char* purpose) {
  return "/dev/shm/pizarra-fuzz-" + std::string(purpose) + "-" + std::to_string(getpid());
}

std::string sound_file() {
  const std::string path = path_for("sound");
  journal::remove_journal(path);
  {
    const auto file = journal::JournalFile::open(path, {}).value();
    store::Store store;
    if (!file->recover(store) || !file->append({sound_lines, "", true})) std::abort();
  }
  std::string contents = contents_of(path);
  journal::remove_journal(path);
  return contents;
}

void open_damaged(std::string_view damage) {
  static const std::string sound = sound_file();
  std::string contents = sound;
  const auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(damage[i])); };
  for (; damage.size() >= 3; damage.remove_prefix(3)) {
    contents[(byte(0) << 8 | byte(1)) % contents.size()] = damage[2];
  }
  if (damage.size() == 2) contents.resize((byte(0) << 8 | byte(1)) % contents.size());
  if (damage.size() == 1) contents.resize(contents.size() * byte(0) / 256);
  const std::string path = path_for("damaged");
  journal::remove_journal(path);
  std::ofstream(path, std::ios::binary) << contents;
  {
    const Result<std::shared_ptr<journal::JournalFile>> file = journal::JournalFile::open(path, {});
    store::Store store;
    if (file && (*file)->recover(store)) use(store);
  }
  journal::remove_journal(path);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view text(reinterpret_cast<const char*>(data), size);
  if (text.starts_with('!')) {
    open_damaged(text.substr(1));
    return 0;
  }
  store::Store store;
  if (journal::replay(text, store)) use(store);
  return 0;
}
