#include "tests/blackboard/cluster/real_etcd.hpp"

#include <csignal>
#include <fcntl.h>
#include <filesystem>
#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>
#include <vector>

#include "lisp/installed_program.hpp"
#include "tests/free_port.hpp"
#include "tests/scratch.hpp"
#include "tests/whole_file.hpp"

namespace pizarra::cluster {

bool RealEtcd::is_installed() { return installed_program("etcd").has_value(); }

RealEtcd::RealEtcd(const std::string& certificates, const std::vector<std::string>& more)
    : port_(free_port()), folder_(fmt::format("{}etcd-{}", scratch_folder(), port_)) {
  const std::string program = installed_program("etcd").value();
  const std::string client = fmt::format("{}://127.0.0.1:{}", certificates.empty() ? "http" : "https", port_);
  const std::string peer = fmt::format("http://127.0.0.1:{}", free_port());
  std::vector<std::string> words = {program,
                                    "--data-dir=" + folder_,
                                    "--listen-client-urls=" + client,
                                    "--advertise-client-urls=" + client,
                                    "--listen-peer-urls=" + peer,
                                    "--initial-advertise-peer-urls=" + peer,
                                    "--initial-cluster=default=" + peer,
                                    "--unsafe-no-fsync",
                                    "--heartbeat-interval=50",
                                    "--election-timeout=500"};
  if (!certificates.empty()) {
    words.insert(words.end(),
                 {"--cert-file=" + certificates + "/server.crt", "--key-file=" + certificates + "/server.key",
                  "--trusted-ca-file=" + certificates + "/ca.crt", "--client-cert-auth"});
  }
  words.insert(words.end(), more.begin(), more.end());
  pid_ = fork();
  if (pid_ != 0) return;
  const int log = open((folder_ + ".log").c_str(), O_WRONLY | O_CREAT, 0600);
  dup2(log, STDOUT_FILENO);
  dup2(log, STDERR_FILENO);
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  execv(program.c_str(), arguments.data());
  _exit(127);
}

RealEtcd::~RealEtcd() {
  kill(pid_, SIGKILL);
  waitpid(pid_, nullptr, 0);
  std::error_code gone_already;
  std::filesystem::remove_all(folder_, gone_already);
}

std::string RealEtcd::address(const std::string& cell) const {
  return fmt::format("etcd://127.0.0.1:{}/{}", port_, cell);
}

std::string RealEtcd::said() const { return whole_file(folder_ + ".log"); }

void RealEtcd::signal(int number) const {
  kill(pid_, number);
  // Its threads do not stop at once.
  if (number == SIGSTOP) waitpid(pid_, nullptr, WUNTRACED);
}

}  // namespace pizarra::cluster
