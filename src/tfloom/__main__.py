"""`python -m tfloom`: the command line for where no script directory is on the path."""

import sys

from tfloom.cli.main import main

sys.exit(main())
