// A plug-in of another ABI.

extern "C" const int pizarra_plugin_abi;
const int pizarra_plugin_abi = 99;
