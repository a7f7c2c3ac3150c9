#pragma once

// An etcd of one member at a free port of this machine, for a test; gone with the object. A test elsewhere says why it
// is skipped.
//
//   if (!RealEtcd::is_installed()) GTEST_SKIP() << "etcd is not installed";
//   RealEtcd etcd;
//   etcd.address("cell");               // etcd://127.0.0.1:PORT/cell

#include <string>
#include <sys/types.h>
#include <vector>

namespace pizarra::cluster {

class RealEtcd {
 public:
  static bool is_installed();
  // With certificates of that folder, where one is named: server.crt and server.key, and ca.crt, by which a client must
  // be known too.
  explicit RealEtcd(const std::string& certificates = "", const std::vector<std::string>& more = {});
  RealEtcd(const RealEtcd&) = delete;
  RealEtcd& operator=(const RealEtcd&) = delete;
  ~RealEtcd();
  std::string address(const std::string& cell) const;
  void signal(int number) const;
  // Its own log.
  std::string said() const;

 private:
  pid_t pid_ = 0;
  int port_ = 0;
  std::string folder_;
};

}  // namespace pizarra::cluster
