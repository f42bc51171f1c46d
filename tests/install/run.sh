#!/usr/bin/env bash
# run.sh BUILD SOURCE: installs the build tree BUILD into a temporary place, moves that, and builds
# and runs the user's project against it.
set -euo pipefail
build=$1 source=$2
place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

cmake --install "$build" --prefix "$place/first" >"$place/install.log"
mv "$place/first" "$place/prefix" # an installation may be moved
if grep -rlF -e "$source/" -e "$build/" "$place/prefix" --include='*.cmake' --include='*.hpp'; then
  echo "the files above name the source or the build tree"
  exit 1
fi
cmake -G Ninja -S "$source/tests/install" -B "$place/build" -DCMAKE_PREFIX_PATH="$place/prefix" \
  -DCMAKE_BUILD_TYPE=Release
cmake --build "$place/build"
"$place/build/user"

# The Python package, if there is one, from where it was installed.
package=$(find "$place/prefix/lib" -type d -name liesl -path '*-packages/*')
if [[ -n $package ]]; then
  (cd / && PYTHONPATH=$(dirname "$package") /usr/bin/python3 -c "
import liesl, pathlib
assert pathlib.Path(liesl.__file__).parent == pathlib.Path('$package'), liesl.__file__
r = liesl.Scene.load('$source/data/scenes/pendulum.toml').change({'simulation.duration': 0.01}).run()
r.check()
print('Python package:', r.summary['status'])")
fi

# What man and bash read of the program that is installed.
if [[ -x $place/prefix/bin/liesl ]]; then
  grep -q '^.TH LIESL' "$place/prefix/share/man/man1/liesl.1"
  bash -c "source '$place/prefix/share/bash-completion/completions/liesl' && complete -p liesl"
fi

# The program, by its path and by a link: bin/liesl finds what it starts, and that its own files.
if [[ -x $place/prefix/bin/liesl ]]; then
  ln -s "$place/prefix/bin/liesl" "$place/link"
  for program in "$place/prefix/bin/liesl" "$place/link"; do
    "$program" --version | head -1
    "$program" run "$source/data/scenes/pendulum.toml" -o "$place/run" --force --quiet \
      --set simulation.duration=0.01
  done
  "$place/link" new scene --like pendulum -o "$place/new.toml" --quiet
  schema=$(sed -n '1s/^#:schema //p' "$place/new.toml")
  [[ $schema == "$place/prefix/"* && -f $schema ]]
  mkdir "$place/case"
  printf 'scene = "%s"\n[grid]\nrho = { key = "simulation.rho_inf", values = [0.8, 0.9] }\n' \
    "$source/data/scenes/pendulum.toml" >"$place/batch.toml"
  "$place/link" batch "$place/batch.toml" -o "$place/case/batch" -j 1 --no-report --quiet
fi
