#!/bin/sh
# copy_sources.sh FROM PLAIN STRIPPED: copies the engine's sources twice, to STRIPPED without the statements that make
# events. Such a statement begins with `if constexpr (Observer::watches)` and ends a line with `});`.
# Neither copy has what is instantiated for somebody who watches. Once stripped it would be the twin of what is
# instantiated for nobody; compilers merge twins, and then inline other functions than before.
set -eu
mkdir -p "$2" "$3"
for file in "$1"/*.h "$1"/*.cpp; do
  name=$(basename "$file")
  awk '
    /^template .*<Observer>\(/ { watched = 1 }
    !watched { print }
    watched && /;[ \t]*$/ { watched = 0 }
    END { exit watched }
  ' "$file" >"$2/$name"
  awk '
    /if constexpr \(Observer::watches\)/ { event = 1 }
    !event { print }
    event && /}\);[ \t]*$/ { event = 0 }
    END { exit event }  # a statement without an end would have taken the rest of the file with it
  ' "$2/$name" >"$3/$name"
done
