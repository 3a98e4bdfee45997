#!/bin/sh
# A Slurm cluster of this one machine, for tests, as root, with a configuration of its own:
#   slurm_node.sh start DIRECTORY CORES   leaves DIRECTORY/slurm.conf (for SLURM_CONF)
#   slurm_node.sh stop DIRECTORY
#   slurm_node.sh kill-controller DIRECTORY; slurm_node.sh start-controller DIRECTORY
#   slurm_node.sh resume-node DIRECTORY   takes a drained node back into service
set -eu
directory=$2
export SLURM_CONF="$directory/slurm.conf"
PATH=$PATH:/usr/sbin

configure() {  # CORES
  mkdir -p "$directory/state" "$directory/spool"
  host=$(hostname -s)
  memory=$(awk '/^MemTotal/ { print int($2 / 1024) }' /proc/meminfo)
  # Ports of this directory's own: a machine may have a Slurm, and tests run side by side.
  port=$((20000 + $(echo "$directory" | cksum | cut -d ' ' -f 1) % 20000))
  cat >"$SLURM_CONF" <<END
ClusterName=slosh
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmdPort=$((port + 1))
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$directory/munge/socket
CryptoType=crypto/munge
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
JobAcctGatherType=jobacct_gather/none
ReturnToService=2
SlurmdTimeout=10
KillWait=5
MpiDefault=none
StateSaveLocation=$directory/state
SlurmdSpoolDir=$directory/spool
SlurmctldPidFile=$directory/slurmctld.pid
SlurmdPidFile=$directory/slurmd.pid
SlurmctldLogFile=$directory/slurmctld.log
SlurmdLogFile=$directory/slurmd.log
SchedulerParameters=sched_interval=1
NodeName=$host NodeAddr=127.0.0.1 CPUs=$1 Boards=1 SocketsPerBoard=1 CoresPerSocket=$1 ThreadsPerCore=1 RealMemory=$memory State=UNKNOWN
PartitionName=all Nodes=$host Default=YES MaxTime=INFINITE State=UP
END
}

# munged trusts only directories and keys of its own user.
start_munge() {
  mkdir -p "$directory/munge"
  dd if=/dev/urandom of="$directory/munge/key" bs=1024 count=1 2>/dev/null
  chmod 0711 "$directory/munge"
  chmod 0400 "$directory/munge/key"
  chown -R munge "$directory/munge"
  setpriv --reuid munge --regid munge --clear-groups munged --force --key-file="$directory/munge/key" \
    --socket="$directory/munge/socket" --pid-file="$directory/munge/pid" --seed-file="$directory/munge/seed" \
    --log-file="$directory/munge/log"
}

wait_until() {  # COMMAND...
  for _ in $(seq 100); do
    if "$@" >/dev/null 2>&1; then return; fi
    sleep 0.1
  done
  echo "slurm_node.sh: still not so after 10 s: $*" >&2
  exit 1
}

end_of() {  # PID_FILE SIGNAL
  if [ -s "$1" ]; then
    pid=$(cat "$1")
    kill "-$2" "$pid" 2>/dev/null || return 0
    wait_until sh -c "! kill -0 $pid"
  fi
}

node_is_idle() { [ "$(sinfo -h -o %T)" = idle ]; }

case $1 in
  start)
    configure "$3"
    start_munge
    slurmctld
    slurmd
    wait_until node_is_idle
    ;;
  kill-controller) end_of "$directory/slurmctld.pid" KILL ;;
  start-controller) slurmctld ;;
  # A controller that was killed may give the number of a job away again that it had not saved, and
  # drains the node that knows the number already.
  resume-node) scontrol update "nodename=$(hostname -s)" state=resume 2>/dev/null || true ;;
  stop)
    scancel -u root 2>/dev/null || true
    end_of "$directory/slurmd.pid" TERM
    end_of "$directory/slurmctld.pid" TERM
    end_of "$directory/munge/pid" TERM
    ;;
esac
