// Any bytes as calls of the C interface, half of the time captured and then played again to the same bits: wrong and
// missing handles, removed bodies, sizes, strides, enumerators and numbers of all kinds, nulls wherever a pointer is
// taken. Every call ends with a status, and one that is refused leaves a message.
//
// Handles that were released and memory that is not there are the caller's mistakes, which nobody can tell.
#include "c/calls.hpp"

void Calls::run() {
  for (int calls = 0; calls < 40 && !in.empty(); ++calls) switch (in.byte() % 16) {
    case 0:
    case 1:
    case 2: make_shape(); break;
    case 3: ask_shape(); break;
    case 4: ask_blow(); break;
    case 5: ask_pair(); break;
    case 6: ask_ray(); break;
    case 7: ask_cast(); break;
    case 8: ask_batch(); break;
    case 9: change_world(); break;
    case 10: change_simulation(); break;
    case 11: change_plane_world(); break;
    case 12: change_plane_simulation(); break;
    case 13: ask_hull(); break;
    case 14: ask_broad_phase(); break;
    default: plane();
    }
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
  Calls(Bytes(bytes, size)).run();
  return 0;
}
