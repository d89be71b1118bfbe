"""What whole processes take, and an X server for those that draw on one."""
import contextlib, os, subprocess, sys, time


def measure(command, folder=None, environment=None):
    """CPU seconds and peak megabytes of one process, which must end well."""
    process = subprocess.Popen(command, cwd=folder, env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    errors = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    process.returncode = os.waitstatus_to_exitcode(status)
    if process.returncode != 0:
        sys.stderr.buffer.write(errors)
        sys.exit(f"bench: {' '.join(command)} ended with {process.returncode}")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


@contextlib.contextmanager
def screen(size):
    """The environment of processes that draw on a server of their own, which is started once and charged to none."""
    display = f":{90 + os.getpid() % 100}"
    server = subprocess.Popen(["Xvfb", display, "-screen", "0", size + "x24"], stderr=subprocess.DEVNULL)
    try:
        time.sleep(1)
        yield dict(os.environ, DISPLAY=display)
    finally:
        server.terminate()
        server.wait()
