// `hosts` and `host join`: who is in a cell, and how a machine comes to be.

#include <csignal>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <sstream>
#include <zmq.hpp>

#include "blackboard/wire/wire.hpp"
#include "lisp/installed_program.hpp"
#include "tests/programs/running.hpp"
#include "tests/programs/shell.hpp"
#include "tests/scratch.hpp"
#include "tests/source_dir.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::programs {
namespace {

using std::chrono::seconds;
namespace files = std::filesystem;

class HostsOfACell : public testing::Test {
 protected:
  void SetUp() override {
    files::remove_all(folder_);
    files::create_directories(folder_);
    write_cell("tcp://127.0.0.1:7943");
  }
  void write_cell(const std::string& address) {
    std::ofstream(cell_) << "(cell two-hosts (world (cube circle (at 450 -80))) (domain \"" << source_dir()
                         << "/domains/blocks.scm\") (board \"bench\" \"" << address
                         << "\") (host \"bench\" (agents robot vision)) (host \"desk\" (agents planner)))\n";
  }
  static Said run(const std::string& words) { return shell(std::string(PIZARRA_CELL) + " " + words + " 2>&1"); }
  Said join(const std::string& host) {
    return run("host join '" + cell_ + "' --host " + host + " --dir " + keys_ + " --service-dir " + folder_ + "units");
  }
  // The address that it listens at.
  std::string comes_up(const Running& board) {
    const auto ready = [&] { return board.said().contains("ready on "); };
    EXPECT_TRUE(wait_until(ready, seconds(60))) << board.said();
    const std::string said = board.said();
    const std::size_t begin = said.find("ready on ") + std::string("ready on ").size();
    return said.substr(begin, said.find_first_of(" \n", begin) - begin);
  }
  std::string line_of_service(const std::string& name) {
    std::ifstream in(service_);
    for (std::string line; std::getline(in, line);) {
      if (line.starts_with(name + "=")) return line.substr(name.size() + 1);
    }
    return {};
  }

  const std::string folder_ = scratch_folder() + "hosts/";
  const std::string cell_ = folder_ + "two hosts.scm";
  const std::string keys_ = folder_ + "keys";
  const std::string service_ = folder_ + "units/pizarra-two-hosts.service";
};

TEST_F(HostsOfACell, AreShownWithThoseWhoseBuildTheBoardCannotSpeakWith) {
  const Running board({PIZARRA_BOARD, "--listen", "ipc://" + folder_ + "board.ipc"}, folder_ + "board.log");
  const std::string address = comes_up(board);
  write_cell(address);
  const std::string hosts = "hosts '" + cell_ + "'";
  EXPECT_FALSE(run(hosts).text.contains("refused")) << run(hosts).text;
  zmq::context_t context;
  zmq::socket_t stranger(context, zmq::socket_type::dealer);
  stranger.set(zmq::sockopt::linger, 0);
  stranger.connect(address);
  ASSERT_TRUE(stranger.send(zmq::str_buffer("(hello \"desk\" 0 9)")));
  const std::string sentence = "refused who comes without a key: the client speaks protocol 9 and the board protocol " +
                               std::to_string(wire::protocol) + ", more than one apart: bring the board up to date\n";
  EXPECT_TRUE(wait_until([&] { return run(hosts).text.contains(sentence); }, seconds(60))) << run(hosts).text;
  const Said json = run(hosts + " --json");
  EXPECT_EQ(json.status, 0) << json.text;
  EXPECT_TRUE(json.text.contains("{\"refused\":\"\",\"newest\":\"the client speaks protocol 9 ")) << json.text;
}

TEST_F(HostsOfACell, AreShownWithTheProcessesThatWereGivenUpAndWithNoLeaderThatOthersMakeUp) {
  const Running board({PIZARRA_BOARD, "--listen", "ipc://" + folder_ + "board.ipc"}, folder_ + "board.log");
  const std::string at = " --board " + comes_up(board);
  const std::string process =
      "(relation process ((host string) (name string) (running symbol) (restarts integer) "
      "(newest string)) (key host name))";
  EXPECT_EQ(run("declare '" + process + "'" + at).status, 0);
  EXPECT_EQ(run("tell '(process \"desk\" \"log\" no 11 \"failed 12 times in a row and is given up\")'" + at).status, 0);
  const Said made_up = run("declare '(relation board-leads ((name string)) (key))'" + at);
  EXPECT_TRUE(made_up.text.contains("board-leads is the board's own")) << made_up.text;
  const Said said = run("hosts '" + cell_ + "'" + at);
  EXPECT_TRUE(said.text.contains("desk             away ")) << said.text;
  EXPECT_TRUE(said.text.contains("\n  log: failed 12 times in a row and is given up\n")) << said.text;
  const Said json = run("hosts '" + cell_ + "' --json" + at);
  EXPECT_TRUE(json.text.contains("\"leads\":false") && json.text.contains("\"down\":\"log: failed 12 times"))
      << json.text;
}

TEST_F(HostsOfACell, AreJoinedByAMachineThatRunsTheServiceMadeForIt) {
  ASSERT_EQ(shell(std::string(PIZARRA_KEYS) + " keys new board --dir " + keys_).status, 0);
  const Said joined = join("desk");
  ASSERT_EQ(joined.status, 0) << joined.text;
  EXPECT_TRUE(joined.text.contains("keys/desk.key  bring it to the board's folder of keys\n")) << joined.text;
  EXPECT_TRUE(joined.text.contains("systemctl --user enable --now pizarra-two-hosts\n")) << joined.text;
  const Running board({PIZARRA_BOARD, "--listen", "tcp://127.0.0.1:*", "--keys", keys_}, folder_ + "board.log");
  write_cell(comes_up(board));
  const std::string hosts = "hosts '" + cell_ + "' --key " + keys_ + "/desk.secret";
  EXPECT_TRUE(run(hosts).text.contains("desk             away       -")) << run(hosts).text;
  // As systemd starts it: of what is escaped for it, these words hold nothing that a shell takes otherwise.
  const std::string command = "exec env " + line_of_service("Environment") + " " + line_of_service("ExecStart");
  Running up({"/bin/sh", "-c", command}, folder_ + "up.log");
  const std::string there = std::string("desk             there      pizarra ") + PIZARRA_VERSION;
  EXPECT_TRUE(wait_until([&] { return run(hosts).text.contains(there); }, seconds(60))) << run(hosts).text << up.said();
  const Said keyless = run("hosts '" + cell_ + "'");
  EXPECT_TRUE(keyless.text.contains(there)) << "what runs here has a key: " << keyless.text;
  up.signal(SIGTERM);
  EXPECT_EQ(up.end(seconds(60)), 0) << up.said();
}

TEST_F(HostsOfACell, HaveAServiceWithoutSecretsAndKeepTheKeyThatTheyHave) {
  const Said joined = join("desk");
  ASSERT_EQ(joined.status, 0) << joined.text;
  EXPECT_TRUE(joined.text.contains("keys/board.key  bring it here from there\n")) << joined.text;
  const std::string secret = whole_file(keys_ + "/desk.secret");
  const files::perms readable = files::status(keys_ + "/desk.secret").permissions();
  EXPECT_EQ(readable & (files::perms::group_all | files::perms::others_all), files::perms::none);
  const std::string service = whole_file(service_);
  std::istringstream words(secret);
  for (std::string word; words >> word;) {
    const bool is_told = service.contains(word) || joined.text.contains(word);
    EXPECT_FALSE(word.size() > 20 && is_told) << "the secret itself";
  }
  EXPECT_EQ(line_of_service("Environment"), "\"PIZARRA_KEY=" + keys_ + "/desk.secret\"");
  EXPECT_EQ(line_of_service("ExecStart"), '"' + std::string(PIZARRA_CELL) + "\" up \"" + cell_ + "\" --host \"desk\"");
  EXPECT_EQ(line_of_service("Restart"), "on-failure") << "`down` is a normal end";
  ASSERT_EQ(join("desk").status, 0);
  EXPECT_EQ(whole_file(keys_ + "/desk.secret"), secret) << "the board may know it already";
  EXPECT_EQ(whole_file(service_), service);
}

TEST_F(HostsOfACell, HaveAServiceWithTheMemberOfTheLogAndAreToldWhatIsMissing) {
  if (!installed_program("etcd")) GTEST_SKIP() << "etcd is not installed (etcd-server)";
  write_cell("tcp://10.0.0.1:7943,tcp://10.0.0.2:7943");
  const std::string certificates = folder_ + "certificates";
  files::create_directories(certificates);
  std::ofstream(certificates + "/ca.crt") << "of the authority";
  const std::string log = " --log etcd://10.0.0.1,10.0.0.2,10.0.0.3/blocks --log-certificates " + certificates +
                          " --log-here 10.0.0.2 --log-folder " + folder_ + "member";
  const std::string join = "host join '" + cell_ + "' --dir " + keys_ + " --service-dir " + folder_ + "units";
  const Said wrong = run(join + " --host desk" + log + " --standby tcp://10.0.0.9:7943");
  EXPECT_EQ(wrong.status, 2) << wrong.text;
  EXPECT_TRUE(wrong.text.contains("no client would look for a board at --standby tcp://10.0.0.9:7943")) << wrong.text;
  const Said no_log = run(join + " --host desk --log banana");
  EXPECT_EQ(no_log.status, 2) << no_log.text;
  EXPECT_TRUE(no_log.text.contains("a log's address is etcd://A,B,C/CELL")) << no_log.text;
  EXPECT_FALSE(files::exists(service_));
  const Said joined = run(join + " --host desk" + log + " --standby tcp://10.0.0.2:7943");
  ASSERT_EQ(joined.status, 0) << joined.text;
  for (const char* name : {"server.crt", "server.key", "client.crt", "client.key"}) {
    EXPECT_TRUE(joined.text.contains(certificates + "/" + name + "  bring it here")) << name << "\n" << joined.text;
  }
  EXPECT_FALSE(joined.text.contains("/ca.crt")) << joined.text;
  EXPECT_EQ(files::status(folder_ + "member").permissions(), files::perms::owner_all);
  EXPECT_TRUE(line_of_service("ExecStart")
                  .ends_with("--host \"desk\" \"--log\" \"etcd://10.0.0.1,10.0.0.2,10.0.0.3/blocks\" "
                             "\"--log-certificates\" \"" +
                             certificates + "\" \"--log-here\" \"10.0.0.2\" \"--log-folder\" \"" + folder_ +
                             "member\" \"--standby\" \"tcp://10.0.0.2:7943\""))
      << line_of_service("ExecStart");
  const Said board = run(join + " --host bench --force" + log);
  EXPECT_EQ(board.status, 0) << board.text;
}

// `%` is a specifier of systemd wherever it stands, `$` a variable in the arguments of a program alone.
TEST_F(HostsOfACell, HaveAServiceThatTakesTheNamesOfFilesAsTheyAre) {
  const std::string odd = folder_ + "$HOME 50%/";
  files::create_directories(odd);
  files::copy_file(cell_, odd + "cell.scm");
  const Said joined =
      run("host join '" + odd + "cell.scm' --host desk --dir '" + odd + "keys' --service-dir " + folder_ + "units");
  ASSERT_EQ(joined.status, 0) << joined.text;
  EXPECT_EQ(line_of_service("Environment"), "\"PIZARRA_KEY=" + folder_ + "$HOME 50%%/keys/desk.secret\"");
  const std::string arguments = line_of_service("ExecStart");
  EXPECT_TRUE(arguments.ends_with(" \"" + folder_ + "$$HOME 50%%/cell.scm\" --host \"desk\"")) << arguments;
}

TEST_F(HostsOfACell, AreNotMadeOfAHostThatTheCellDoesNotHaveNorOfTheBoards) {
  const Said board = join("bench");
  EXPECT_EQ(board.status, 2) << board.text;
  EXPECT_TRUE(board.text.contains("bench has the cell's board: its keys are made with `keys new`")) << board.text;
  const Said unknown = join("lap-top");
  EXPECT_EQ(unknown.status, 2) << unknown.text;
  EXPECT_TRUE(unknown.text.contains("the cell has no host lap-top: it has bench, desk")) << unknown.text;
  EXPECT_FALSE(files::exists(keys_)) << "no key";
  EXPECT_FALSE(files::exists(service_)) << "and no service";
}

TEST_F(HostsOfACell, AreNotMadeWhereTheServiceCannotBeWritten) {
  std::ofstream(folder_ + "units") << "a file in place of the folder";
  const Said refused = join("desk");
  EXPECT_EQ(refused.status, 4) << refused.text;
  EXPECT_TRUE(refused.text.contains("the folder of the service cannot be made: " + folder_ + "units: Not a directory"))
      << refused.text;
}

TEST_F(HostsOfACell, AreNotMadeWhereTheFolderOfTheMemberCannotBeMade) {
  if (!installed_program("etcd")) GTEST_SKIP() << "etcd is not installed (etcd-server)";
  std::ofstream(folder_ + "file") << "in place of a folder";
  const Said refused =
      run("host join '" + cell_ + "' --host desk --dir " + keys_ + " --service-dir " + folder_ +
          "units --log etcd://127.0.0.1/blocks --log-here 127.0.0.1 --log-folder " + folder_ + "file/member");
  EXPECT_EQ(refused.status, 4) << refused.text;
  const std::string sentence = "the member's folder cannot be made: " + folder_ + "file/member: Not a directory";
  EXPECT_TRUE(refused.text.contains(sentence)) << refused.text;
  EXPECT_FALSE(files::exists(keys_)) << "no key";
  EXPECT_FALSE(files::exists(service_)) << "and no service";
}

TEST_F(HostsOfACell, KeepAServiceThatSomebodyChangedUnlessItIsToBeReplaced) {
  files::create_directories(folder_ + "units");
  std::ofstream(service_) << "[Service]\nExecStart=/bin/mine\n";
  const Said refused = join("desk");
  EXPECT_EQ(refused.status, 2) << refused.text;
  EXPECT_TRUE(refused.text.contains("there is another service in " + service_ + ": --force replaces it"))
      << refused.text;
  EXPECT_EQ(line_of_service("ExecStart"), "/bin/mine");
  EXPECT_FALSE(files::exists(keys_)) << "nothing was made";
  const Said forced = join("desk --force");
  EXPECT_EQ(forced.status, 0) << forced.text;
  EXPECT_TRUE(line_of_service("ExecStart").ends_with("--host \"desk\"")) << line_of_service("ExecStart");
}

}  // namespace
}  // namespace pizarra::programs
