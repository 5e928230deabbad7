"""Make a certificate authority, and a certificate for each name; needs the program openssl.

    python make_certificates.py FOLDER robot=192.168.1.10 base laptop

A name is the certificate's common name, by which access rules know who it is. A machine that others connect to also
needs the address that they use. Give each machine ca.pem and its own two files, NAME.pem and NAME.key, and keep ca.key
offline.
"""

import ipaddress
import subprocess
import sys
from pathlib import Path

DAYS = "825"


def openssl(*words: object) -> None:
    """Run openssl; end the program with its message if it fails."""
    done = subprocess.run(["openssl", *map(str, words)], capture_output=True, text=True, check=False)
    if done.returncode:
        sys.exit(f"openssl {words[0]}: {done.stderr.strip()}")


def make_authority(folder: Path) -> None:
    """Write ca.key and ca.pem, unless the folder has them."""
    if not (folder / "ca.pem").exists():
        key = ("-newkey", "ec", "-pkeyopt", "ec_paramgen_curve:P-256", "-nodes", "-keyout", folder / "ca.key")
        openssl("req", "-x509", *key, "-subj", "/CN=robots", "-days", DAYS, "-out", folder / "ca.pem")


def kind_of(address: str) -> str:
    """Return what a certificate calls an address: IP or DNS."""
    try:
        ipaddress.ip_address(address)
    except ValueError:
        return "DNS"
    return "IP"


def make_certificate(folder: Path, name: str, addresses: list[str]) -> None:
    """Write NAME.key and NAME.pem, signed by the authority, valid for the name and the addresses."""
    names = [f"DNS:{name}", *(f"{kind_of(address)}:{address}" for address in addresses)]
    request, extensions = folder / f"{name}.csr", folder / f"{name}.ext"
    extensions.write_text(f"subjectAltName={','.join(names)}\nbasicConstraints=CA:FALSE\n")
    key = (
        "-newkey",
        "ec",
        "-pkeyopt",
        "ec_paramgen_curve:P-256",
        "-nodes",
        "-keyout",
        folder / f"{name}.key",
    )
    openssl("req", *key, "-subj", f"/CN={name}", "-out", request)
    authority = ("-CA", folder / "ca.pem", "-CAkey", folder / "ca.key", "-CAcreateserial")
    extended = ("-extfile", extensions, "-days", DAYS)
    openssl("x509", "-req", "-in", request, *authority, *extended, "-out", folder / f"{name}.pem")
    request.unlink()
    extensions.unlink()


def main() -> None:
    """Make what the command line names."""
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    folder = Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    make_authority(folder)
    for word in sys.argv[2:]:
        name, _, addresses = word.partition("=")
        make_certificate(folder, name, [address for address in addresses.split(",") if address])


if __name__ == "__main__":
    main()
