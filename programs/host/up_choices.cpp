#include "programs/host/up_choices.hpp"

namespace pizarra::host {

void add_log_options(CLI::App& app, UpChoices& choices) {
  CLI::Option* log = app.add_option("--log", choices.log,
                                    "Keep what is durable in an etcd cluster, etcd://A,B,C/CELL, so that another board "
                                    "takes over when this one is gone");
  app.add_option(
         "--log-certificates", choices.certificates,
         "The folder of ca.crt, client.crt and client.key for that cluster; with --log-here also of server.crt and "
         "server.key")
      ->needs(log);
  app.add_flag("--log-insecure", choices.log_insecure, "Connect to that cluster without encryption")->needs(log);
  app.add_option("--standby", choices.standby, "Also run a board on this host, at this address of the cell")
      ->needs(log);
  CLI::Option* log_here =
      app.add_option("--log-here", choices.log_here,
                     "Run an etcd member of that cluster on this host: which address of --log it has")
          ->needs(log)
          ->type_name("ADDRESS");
  CLI::Option* log_folder =
      app.add_option("--log-folder", choices.log_folder, "Where that member keeps its data, on a disk that lasts")
          ->needs(log_here)
          ->type_name("DIR");
  log_here->needs(log_folder);
  app.add_option("--past", choices.past,
                 "Where the board of this host keeps its own past, 1 GB; default: 64 MB in the run's folder")
      ->needs(log)
      ->type_name("DIR");
}

}  // namespace pizarra::host
