#pragma once

// Certificates for a log, in a new folder: of an authority, a server and a client, for addresses of this machine, or
// others.
//
//   if (!make_certificates(folder)) GTEST_SKIP() << "openssl is not installed (openssl)";

#include <cstdlib>
#include <filesystem>
#include <string>

namespace pizarra {

inline bool make_certificates(const std::string& folder, const std::string& names = "IP:127.0.0.1,IP:::1") {
  std::filesystem::create_directories(folder);
  const std::string script =
      "cd '" + folder +
      "' && key='-newkey ec -pkeyopt ec_paramgen_curve:prime256v1 -nodes' &&"
      " printf 'subjectAltName=" +
      names +
      "\\nextendedKeyUsage=serverAuth,clientAuth\\n' > names &&"
      " openssl req -x509 $key -keyout ca.key -out ca.crt -days 2 -subj /CN=authority &&"
      " for name in server client; do"
      "  openssl req $key -keyout $name.key -out $name.csr -subj /CN=$name &&"
      "  openssl x509 -req -in $name.csr -CA ca.crt -CAkey ca.key -CAcreateserial -days 2 -extfile names -out $name.crt"
      "  || exit 1; done";
  return std::system(("( " + script + " ) >/dev/null 2>&1").c_str()) == 0;
}

}  // namespace pizarra
