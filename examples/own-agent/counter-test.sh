#!/bin/sh
# Runs the agent on a board of its own: counter-test.sh PROGRAM, or without a word counter.py beside this file. PIZARRA
# names the command where it is not on the PATH; PYTHONPATH says where Pizarra's Python is, and PYTHON which has zmq.
set -eu

# The PATH's Python need not have zmq: Debian's package is for Debian's alone.
has_zmq() { "$1" -c 'import zmq' 2>/dev/null; }
if [ $# -eq 0 ]; then
  python=${PYTHON:-python3}
  has_zmq "$python" || python=/usr/bin/python3
  if ! has_zmq "$python"; then
    echo "FAILED: no Python has zmq here: apt install python3-zmq" >&2
    exit 1
  fi
  set -- "$python" "$(dirname "$0")/counter.py"
fi
pizarra=${PIZARRA:-pizarra}
folder=$(mktemp -d)
board=ipc://$folder/b
trap 'kill $agent $server 2>/dev/null || true; wait; rm -rf "$folder"' EXIT
agent= server=

"$pizarra" board --listen "$board" >"$folder/board.log" 2>&1 &
server=$!
"$@" "$board" >"$folder/agent.log" 2>&1 &
agent=$!

# Asks until the answer comes, some 20 s long.
expect() {
  tries=0
  until "$pizarra" ask --board "$board" "$1" 2>/dev/null | grep -qF "$2"; do
    tries=$((tries + 1))
    if [ $tries -gt 100 ]; then
      echo "FAILED: $1 does not answer $2" >&2
      cat "$folder/agent.log" >&2
      exit 1
    fi
    sleep 0.2
  done
}

expect '(agent counter ?kind ?host)' '?kind = counter'
"$pizarra" tell --board "$board" '(barrier exit blocked)'
expect '(passed ?count)' '?count = 1'
"$pizarra" tell --board "$board" '(barrier exit free)'
"$pizarra" tell --board "$board" '(barrier exit blocked)'
expect '(passed ?count)' '?count = 2'
"$pizarra" tell --board "$board" '(request r1 counter (count))'
expect '(reply r1 ?answer)' '?answer = (ok 2)'
echo "counter works"
