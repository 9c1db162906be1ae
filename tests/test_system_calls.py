"""Which recorded calls are of files in a folder."""

from pathlib import Path

from tests.sweeps.system_calls import calls


def escaped(text: str) -> str:
    """As `strace -xx` prints it."""
    return "".join(f"\\x{byte:02x}" for byte in text.encode())


def test_a_message_that_names_the_folder_is_no_call_on_it(tmp_path: Path) -> None:
    inside, outside = escaped("/tree/s.h5"), escaped("/said.txt")
    report = tmp_path / "strace.txt"
    report.write_text(
        f'7 openat(AT_FDCWD<{escaped("/")}>, "{inside}", O_RDWR) = 3<{inside}>\n'
        f'7 write(3<{inside}>, "{escaped("text")}", 4 <unfinished ...>\n'
        f'8 write(2<{outside}>, "{inside}", 10) = -1 EIO (Input/output error) (INJECTED)\n'
        f"7 <... write resumed>) = 4\n"
    )
    opened, told, written = calls(report)
    assert [call.is_in(Path("/tree")) for call in (opened, told, written)] == [True, False, True]
    assert (opened.names, written.data) == (["/tree/s.h5"], b"text")
    assert (told.result, told.error) == (-1, "EIO (Input/output error) (INJECTED)")
