"""Drawing within a limited address space: an end with a reason, never a loop.

OpenBLAS, which numpy calls, asks for its buffers until it gets them. Imported before numpy: one thread,
whose buffer is asked for here, against a timer of the process that ends it.
"""

import os
import resource
import signal

SECONDS = 5  # of the processor, for what takes milliseconds


def reserve():
    """Has OpenBLAS take its buffer. Ends the process by SIGPROF where there is no room for it."""
    if resource.getrlimit(resource.RLIMIT_AS)[0] == resource.RLIM_INFINITY:
        return
    signal.signal(signal.SIGPROF, signal.SIG_DFL)
    signal.setitimer(signal.ITIMER_PROF, SECONDS)
    import numpy

    numpy.linalg.inv(numpy.eye(64))
    signal.setitimer(signal.ITIMER_PROF, 0)


os.environ["OPENBLAS_NUM_THREADS"] = "1"
reserve()
