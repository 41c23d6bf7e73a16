#pragma once

namespace proofreel {

/// Fingerprint of the sources that decide how a run comes out (engine, scenario language, peers, measures), as 64 hex
/// digits. What was found with other sources has to be found anew. The build makes it (lab/sources_hash.cmake).
const char* sources_hash();

}  // namespace proofreel
