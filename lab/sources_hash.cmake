# cmake -DROOT=DIR -DOUTPUT=FILE -P sources_hash.cmake: writes a C++ file with the fingerprint of what decides how runs come out.
file(GLOB_RECURSE sources ${ROOT}/engine/*.h ${ROOT}/engine/*.cpp ${ROOT}/scenarios/*.h ${ROOT}/scenarios/*.cpp
  ${ROOT}/lab/peers/*.h ${ROOT}/lab/peers/*.cpp ${ROOT}/lab/measures.* ${ROOT}/lab/grid_run.* ${ROOT}/lab/study_run.*)
list(SORT sources)
set(hashes "")
foreach(source ${sources})
  file(SHA256 ${source} hash)
  string(APPEND hashes "${hash}\n")
endforeach()
string(SHA256 hash "${hashes}")
file(WRITE ${OUTPUT} "#include \"lab/sources_hash.h\"

namespace proofreel {
const char* sources_hash() { return \"${hash}\"; }
}  // namespace proofreel
")
