def page(audits: object) -> str:
    return ""
