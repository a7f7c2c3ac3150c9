// `new agent`: writes an agent of one's own, with a test, from the examples that are shipped.

#include <algorithm>
#include <array>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>

#include "agents/launcher/agent_factory.hpp"
#include "lisp/outside_text.hpp"
#include "lisp/plain_name.hpp"
#include "programs/command_line/command_tools.hpp"
#include "programs/commands/commands.hpp"

namespace pizarra::programs {

namespace {

namespace fs = std::filesystem;

struct NewChoices {
  std::string name;
  std::string folder;
  bool python = false;
  bool cpp = false;
};

// The examples are agents called `counter`, their class `Counter`.
constexpr std::string_view old_name = "counter";
constexpr std::string_view old_class = "Counter";

// Whether the name suits an agent, a file, a CMake project and, in another spelling, a class.
Result<void> check_name(const std::string& name) {
  if (!is_plain_name(name)) {
    return fail("bad-name", fmt::format("an agent's name has letters, digits and dashes, a letter first, {} at most: "
                                        "not {}",
                                        longest_plain_name, text_of_bytes(name)));
  }
  if (launcher::kind_fault(name).empty() || name == "board" || name == "world") {
    return fail("bad-name", fmt::format("Pizarra has an agent {} of its own: take another name", name));
  }
  return {};
}

// my-lamp is the class MyLamp.
std::string class_name(const std::string& name) {
  std::string out;
  bool begins = true;
  for (const char c : name) {
    if (c != '-') out += begins ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    begins = c == '-';
  }
  return out;
}

std::string renamed(std::string text, const std::string& name) {
  const std::array<std::pair<std::string_view, std::string>, 2> changes{
      {{old_name, name}, {old_class, class_name(name)}}};
  for (const auto& [from, to] : changes) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size())) {
      text.replace(at, from.size(), to);
    }
  }
  return text;
}

Result<void> write_file(const fs::path& from, const fs::path& to, const std::string& name) {
  std::ifstream in(from);
  const std::string text(std::istreambuf_iterator<char>(in), {});
  std::ofstream out(to);
  out << renamed(text, name);
  out.close();
  if (!in || !out) return fail("cannot-write", fmt::format("cannot write {}", text_of_bytes(to.string())));
  std::error_code refused;
  fs::permissions(to, fs::status(from).permissions(), refused);
  return {};
}

std::string example_of(const NewChoices& choices) {
  return choices.cpp ? "own-agent" : choices.python ? "own-agent-python" : "own-agent-scheme";
}

Result<std::vector<std::string>> write_agent(const NewChoices& choices, const fs::path& folder) {
  std::error_code refused;
  if (fs::exists(folder, refused)) {
    return fail("exists", fmt::format("{} is there already: take another name, or --in another folder",
                                      text_of_bytes(folder.string())));
  }
  if (!fs::create_directories(folder, refused)) {
    return fail("cannot-write", fmt::format("cannot make {}: {}", text_of_bytes(folder.string()), refused.message()));
  }
  std::vector<std::string> written;
  for (const auto& entry : fs::directory_iterator(shipped_file("examples/" + example_of(choices)))) {
    if (!entry.is_regular_file()) continue;
    const std::string file = renamed(entry.path().filename().string(), choices.name);
    const Result<void> done = write_file(entry.path(), folder / file, choices.name);
    if (!done) return fail(done);
    written.push_back((folder / file).string());
  }
  std::ranges::sort(written);
  return written;
}

// What to type next.
std::string next_steps(const NewChoices& choices, const std::string& folder) {
  const std::string& name = choices.name;
  const std::string python = shipped_file("blackboard/python");
  if (choices.cpp) {
    return fmt::format(
        "Build and test it, where Pizarra is installed, or with -D CMAKE_PREFIX_PATH=PREFIX where it is not in /usr:\n"
        "  cmake -S {0} -B {0}/build && cmake --build {0}/build && ctest --test-dir {0}/build\n"
        "Run it on the board of a cell:\n  {0}/build/{1} BOARD-ADDRESS\n",
        folder, name);
  }
  if (choices.python) {
    return fmt::format(
        "Test it (it needs Debian's python3-zmq):\n  PYTHONPATH={2} {0}/{1}-test.sh\n"
        "Run it on the board of a cell:\n  PYTHONPATH={2} python3 {0}/{1}.py BOARD-ADDRESS\n",
        folder, name, python);
  }
  return fmt::format(
      "Test it:\n  pizarra scheme {0}/{1}.scm --try {0}/{1}-test.scm\n"
      "Run it beside the cell that runs here; it is loaded again whenever it is saved:\n  pizarra scheme {0}/{1}.scm\n"
      "Or in a cell file: (agent {1} (scheme \"{0}/{1}.scm\"))\n",
      folder, name);
}

int write_new_agent(const NewChoices& choices) {
  const Result<void> named = check_name(choices.name);
  if (!named) return complain(named.error(), exit_usage);
  const fs::path folder = choices.folder.empty() ? fs::path(choices.name) : fs::path(choices.folder) / choices.name;
  const Result<std::vector<std::string>> written = write_agent(choices, folder);
  if (!written) return complain(written.error(), written.error().symbol == "exists" ? exit_usage : exit_unavailable);
  for (const std::string& file : *written) fmt::print("{}\n", text_of_bytes(file));
  fmt::print("{}", next_steps(choices, text_of_bytes(folder.string())));
  return exit_reached;
}

}  // namespace

void add_new_command(CLI::App& app, int& status) {
  auto choices = std::make_shared<NewChoices>();
  CLI::App* word = app.add_subcommand("new", "Start an agent of your own, with a test.");
  word->require_subcommand(1);
  CLI::App* agent = word->add_subcommand(
      "agent",
      "Write an agent with a test, ready to run, into a folder of its name: a Scheme file, which needs no "
      "compiler and is replaced while it runs, or Python, or C++.");
  agent->add_option("NAME", choices->name, "The agent's name: letters, digits and dashes, a letter first")->required();
  CLI::Option* python = agent->add_flag("--python", choices->python, "Write it in Python");
  agent->add_flag("--cpp", choices->cpp, "Write it in C++, to be built with an installed Pizarra")->excludes(python);
  agent->add_option("--in", choices->folder, "Make the agent's folder in this folder; default: here");
  agent->footer(help_footer("new agent my-lamp"));
  agent->callback([choices, &status] { status = write_new_agent(*choices); });
}

}  // namespace pizarra::programs
