// SPDX-License-Identifier: Apache-2.0
#include <systemc>

/// Required by SystemC's library; the program has its own main().
int sc_main(int /*argc*/, char** /*argv*/) { return 0; }
