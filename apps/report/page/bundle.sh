#!/usr/bin/env bash
# Makes dist/ of src/: fetches the pinned packages of pins.txt, checks their integrity, bundles.
# For maintainers, after a change of src/ or of a version; needs npm and Debian's esbuild. Building
# and using liesl needs neither: dist/ is in the repository.
set -euo pipefail
cd "$(dirname "$0")"
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p "$work/node_modules"
while read -r name version integrity; do
  npm pack --silent --pack-destination "$work" "$name@$version" >/dev/null
  archive=$work/$name-$version.tgz
  found=sha512-$(openssl dgst -sha512 -binary "$archive" | base64 -w0)
  [[ $found == "$integrity" ]] || { echo "bundle: $name $version is not what pins.txt says" >&2; exit 1; }
  mkdir -p "$work/node_modules/$name"
  tar -xzf "$archive" -C "$work/node_modules/$name" --strip-components=1
  cp "$work/node_modules/$name/LICENSE" "dist/LICENSE.$name"
done < pins.txt
NODE_PATH=$work/node_modules esbuild src/main.js --bundle --minify --format=iife --target=es2020 \
  --legal-comments=none --outfile="$work/report.js"
NODE_PATH=$work/node_modules esbuild src/style.css --bundle --minify --outfile="$work/report.css"
{
  echo "This page holds, besides liesl (BSD-3-Clause):"
  while read -r name version _; do
    printf '\n%s %s\n\n' "$name" "$version"
    cat "dist/LICENSE.$name"
  done < pins.txt
} > dist/notices.txt
cp "$work/report.js" "$work/report.css" dist/
# What dist/ was made of and what came out, for tests/architecture/check_bundle.py.
(export LC_ALL=C; sha256sum pins.txt src/* dist/LICENSE.* dist/notices.txt dist/report.* > dist/sources.sha256)
ls -l dist
