#!/usr/bin/env bash
# slurm_test.sh PROGRAM DATA_DIR DOC: the array script of docs/cluster.md under a Slurm of its own.
#
# Starts munged, slurmctld and slurmd on the loopback, submits the script, cancels it, submits it
# again: every case ends, none is run twice. Ends with 77 (skipped) where Slurm cannot be started.
set -euo pipefail
program=$1 data=$2 doc=$3

skip() { printf 'skipped: %s\n' "$*" >&2; exit 77; }
fail() { printf 'failed: %s\n' "$*" >&2; exit 1; }

export PATH=$PATH:/usr/sbin
for tool in slurmctld slurmd munged sbatch; do
  command -v "$tool" >/dev/null || skip "no $tool; apt-get install slurmctld slurmd munge"
done

dir=$(mktemp -d)
stop() {
  for daemon in slurmd slurmctld munged; do
    [[ -f $dir/$daemon.pid ]] && kill "$(<"$dir/$daemon.pid")" 2>/dev/null || true
  done
  for _ in {1..50}; do
    [[ -f $dir/slurmd.pid || -f $dir/slurmctld.pid ]] || break
    sleep 0.1
  done
  rm -rf "$dir"
}
trap stop EXIT
chmod 755 "$dir"
mkdir "$dir/state" "$dir/spool" "$dir/bin"
ln -s "$program" "$dir/bin/liesl"  # where the script finds it

# --- a cluster of one node -----------------------------------------------------------------------
node=$(hostname -s) port=$((20000 + RANDOM % 20000)) user=$(id -un)
head -c 1024 /dev/urandom >"$dir/munge.key"
chmod 400 "$dir/munge.key"
cat >"$dir/slurm.conf" <<END
ClusterName=test
SlurmctldHost=$node(127.0.0.1)
AuthType=auth/munge
AuthInfo=socket=$dir/munge.sock
CredType=cred/munge
SlurmUser=$user
SlurmdUser=$user
SlurmctldPort=$port
SlurmdPort=$((port + 1))
StateSaveLocation=$dir/state
SlurmdSpoolDir=$dir/spool
SlurmctldPidFile=$dir/slurmctld.pid
SlurmdPidFile=$dir/slurmd.pid
SlurmctldLogFile=$dir/slurmctld.log
SlurmdLogFile=$dir/slurmd.log
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
MpiDefault=none
ReturnToService=2
KillWait=5
NodeName=$node NodeAddr=127.0.0.1 CPUs=$(nproc) State=UNKNOWN
PartitionName=all Nodes=$node Default=YES MaxTime=INFINITE State=UP
END
export SLURM_CONF=$dir/slurm.conf
munged --key-file="$dir/munge.key" --socket="$dir/munge.sock" --pid-file="$dir/munged.pid" \
  --log-file="$dir/munged.log" --seed-file="$dir/munged.seed" --force 2>"$dir/errors" ||
  skip "munged does not start: $(<"$dir/errors")"
slurmctld -c 2>"$dir/errors" || skip "slurmctld does not start: $(<"$dir/errors")"
slurmd -c 2>"$dir/errors" || skip "slurmd does not start: $(<"$dir/errors")"
for _ in {1..100}; do
  sinfo -h -o %T 2>/dev/null | grep -q idle && break
  sleep 0.2
done
sinfo -h -o %T 2>/dev/null | grep -q idle ||
  skip "the node does not come up: $(tail -n 3 "$dir/slurmctld.log" "$dir/slurmd.log")"

# --- the script as it is shown, on a batch of twelve ---------------------------------------------
sed -n '/^```bash$/,/^```$/p' "$doc" | sed '1d;$d' >"$dir/liesl_array.sh"
grep -q '^exec liesl batch' "$dir/liesl_array.sh" || fail "$doc shows no script"
cat >"$dir/batch.toml" <<END
study = "$data/studies/slider_crank_rod.toml"
[grid]
speed = { key = "joints.motor.drive.rate", values = [120, 130, 140, 150] }
limit = { key = "constraints.bending.limit", values = [0.6e-3, 0.8e-3, 1.0e-3] }
END
cd "$dir"
export PATH=$dir/bin:$PATH
submit() { sbatch --parsable --array=1-3 --cpus-per-task=1 "$@" liesl_array.sh batch.toml results; }
marks() { find results/cases -name done.json -printf '%p %T@ %i\n' 2>/dev/null | sort; }

job=$(submit)
for _ in {1..600}; do
  [[ $(marks | wc -l) -ge 2 ]] && break
  sleep 0.05
done
[[ $(marks | wc -l) -ge 2 ]] || fail "no case has ended: $(cat slurm-*.out)"
scancel --full "$job"
for _ in {1..300}; do
  [[ -z $(squeue -h -j "$job" 2>/dev/null) ]] && break
  sleep 0.1
done
marks >before
[[ $(wc -l <before) -lt 12 ]] || fail "the job was done before it could be cancelled"

code=0
submit --wait >/dev/null || code=$?
[[ $code -eq 0 ]] || fail "the array ended with $code: $(cat slurm-*.out)"
[[ $(marks | wc -l) -eq 12 ]] || fail "$(marks | wc -l) of 12 cases have ended: $(cat slurm-*.out)"
[[ -z $(marks | comm -23 before -) ]] || fail "a case that was done was run again"
[[ $(wc -l <results/results.csv) -eq 13 ]] || fail "results.csv has not a row a case"
[[ $(grep -cE "converged|optimal" results/results.csv) -eq 12 ]] || fail "$(<results/results.csv)"
grep -q '"status": "done"' results/summary.json || fail "$(<results/summary.json)"
echo "12 cases in 3 array jobs; $(wc -l <before) were done when the first array was cancelled"
